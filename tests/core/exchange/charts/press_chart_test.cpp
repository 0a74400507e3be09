#include "core/exchange/charts/press_chart.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace esm {
namespace {

const std::vector<NamedPress> presses{{"before", {{0, 0}, {0.002, 0.1}, {0.004, 0.3}}},
                                      {"after", {{0, 0}, {0.004, 0.12}}}};

TEST(PressChart, ShowsEveryPointWithinTheAxes) {
    const Drawing chart = pressChart(presses);
    EXPECT_EQ(chart.dots.size(), 5U + 2U); // points, and one of the legend for each curve
    for (const Drawing::Dot& dot : chart.dots) {
        EXPECT_GE(dot.centre.x, 0);
        EXPECT_LE(dot.centre.x, chart.width);
        EXPECT_GE(dot.centre.y, 0);
        EXPECT_LE(dot.centre.y, chart.height);
    }
    const auto isNamed = [&](const std::string& name) {
        return std::any_of(chart.labels.begin(), chart.labels.end(),
                           [&](const Drawing::Label& label) { return label.text == name; });
    };
    EXPECT_TRUE(isNamed("before"));
    EXPECT_TRUE(isNamed("after"));
    // More force lies higher, more depth farther right.
    EXPECT_LT(chart.dots[2].centre.y, chart.dots[1].centre.y);
    EXPECT_GT(chart.dots[2].centre.x, chart.dots[1].centre.x);
}

TEST(PressChart, HasAxesWithoutAForceToo) {
    const Drawing chart = pressChart({{"nothing", {{0, 0}}}});
    for (const Drawing::Line& line : chart.lines)
        EXPECT_TRUE(std::isfinite(line.to.x) && std::isfinite(line.to.y));
    EXPECT_LT(chart.lines.size(), 50U);
}

TEST(PressChart, ShortensNamesOfFiles) {
    const Drawing chart =
        pressChart({{"Öffnung der Gallenblase, zweite", {{0, 0}, {0.002, 0.1}}}, {"a\nb", {}}});
    const auto isNamed = [&](const std::string& name) {
        return std::any_of(chart.labels.begin(), chart.labels.end(),
                           [&](const Drawing::Label& label) { return label.text == name; });
    };
    EXPECT_TRUE(isNamed("?ffnung der Galle..."));
    EXPECT_TRUE(isNamed("a?b"));
}

TEST(PressCsv, HasALineForEachPoint) {
    EXPECT_EQ(pressCsv(presses), "name,depth_m,force_n\nbefore,0,0\nbefore,0.002,0.1\nbefore,0.004,0.3\n"
                                 "after,0,0\nafter,0.004,0.12\n");
}

} // namespace
} // namespace esm
