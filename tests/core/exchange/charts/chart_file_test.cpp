#include "core/exchange/charts/chart_file.h"

#include "core/support/errors.h"
#include "core/support/file_io.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

using namespace esm;

namespace {

Drawing dotAndWords() {
    return {30, 20, {}, {{{15, 10}, 4, {200, 0, 0}}}, {{{2, 18}, "words", Drawing::Anchor::Start}}};
}

std::string textOf(const std::filesystem::path& file) {
    const Bytes bytes = readFile(file);
    return {bytes.begin(), bytes.end()};
}

} // namespace

TEST(ChartFile, IsADrawingWhereItEndsInSvgInWhateverLetters) {
    const TemporaryFolder folder;
    for (const char* name : {"chart.svg", "chart.SVG", "chart.Svg"}) {
        ASSERT_TRUE(isChartFile(name));
        writeChart(dotAndWords(), folder / name);
        EXPECT_EQ(textOf(folder / name), toSvg(dotAndWords())) << name;
    }
}

TEST(ChartFile, IsAPictureOfTheChartsSizeWhereItEndsInPng) {
    const TemporaryFolder folder;
    for (const char* name : {"chart.png", "chart.PNG"}) {
        ASSERT_TRUE(isChartFile(name));
        writeChart(dotAndWords(), folder / name);
        const Bytes bytes = readFile(folder / name);
        const cv::Mat picture = cv::imdecode(bytes, cv::IMREAD_COLOR);
        ASSERT_EQ(picture.size(), cv::Size(30, 20)) << name;
        EXPECT_EQ(picture.at<cv::Vec3b>(10, 15), cv::Vec3b(0, 0, 200));
    }
}

TEST(ChartFile, IsRefusedWhereItEndsInNeither) {
    const TemporaryFolder folder;
    for (const char* name : {"chart.gif", "chart", "svg", ".svg"}) {
        EXPECT_FALSE(isChartFile(name));
        EXPECT_THROW(writeChart(dotAndWords(), folder / name), FileError);
        EXPECT_FALSE(std::filesystem::exists(folder / name));
    }
}
