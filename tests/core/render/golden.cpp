#include "tests/core/render/golden.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace esm {
namespace {

constexpr double largestMean = 1.5;
constexpr int visibleDifference = 24;
constexpr double largestVisibleShare = 0.005;

cv::Mat toOpenCv(const Image& image) {
    cv::Mat result(image.height, image.width, CV_8UC3);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t* pixel = image.at(x, y);
            result.at<cv::Vec3b>(y, x) = {pixel[2], pixel[1], pixel[0]};
        }
    return result;
}

/// Pixels of which some channel differs visibly.
int visiblyDifferent(const cv::Mat& difference) {
    int count = 0;
    for (int y = 0; y < difference.rows; ++y)
        for (int x = 0; x < difference.cols; ++x) {
            const cv::Vec3b pixel = difference.at<cv::Vec3b>(y, x);
            count += std::max({pixel[0], pixel[1], pixel[2]}) > visibleDifference ? 1 : 0;
        }
    return count;
}

} // namespace

testing::AssertionResult matchesGolden(const Image& picture, const std::string& name) {
    const std::filesystem::path golden = std::filesystem::path(ESM_GOLDEN_DIR) / (name + ".png");
    const cv::Mat drawn = toOpenCv(picture);
    if (std::getenv("ESM_UPDATE_GOLDEN")) {
        std::filesystem::create_directories(golden.parent_path());
        if (!cv::imwrite(golden.string(), drawn))
            return testing::AssertionFailure() << "cannot write " << golden;
        return testing::AssertionSuccess();
    }
    const std::filesystem::path kept = ESM_GOLDEN_OUTPUT;
    std::filesystem::create_directories(kept);
    const cv::Mat expected = cv::imread(golden.string(), cv::IMREAD_COLOR);
    if (expected.size() != drawn.size()) {
        cv::imwrite((kept / (name + ".png")).string(), drawn);
        return testing::AssertionFailure() << golden << " is missing or has another size";
    }
    cv::Mat difference;
    cv::absdiff(drawn, expected, difference);
    const cv::Scalar means = cv::mean(difference);
    const double mean = (means[0] + means[1] + means[2]) / 3;
    const double visible = visiblyDifferent(difference) / static_cast<double>(difference.total());
    if (mean <= largestMean && visible <= largestVisibleShare) return testing::AssertionSuccess();
    cv::imwrite((kept / (name + ".png")).string(), drawn);
    cv::imwrite((kept / (name + "-difference.png")).string(), difference);
    return testing::AssertionFailure() << "mean difference " << mean << ", " << 100 * visible
                                       << " % of the pixels differ visibly; see " << kept;
}

} // namespace esm
