#include "core/exchange/charts/time_chart.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace esm {
namespace {

const NamedTimeCurve fading{
    "now",
    {{{0, 0, 0}, {0.05, 0.004, 9}, {0.06, 0.004, 0.5}, {0.2, 0.004, 0.4}, {1, 0.004, 0.31}},
     {0.004, 0.3},
     0.2}};
const NamedTimeCurve sinking{"before",
                             {{{0, 0, 0.1}, {0.5, 0.003, 0.1}, {1, 0.004, 0.1}}, {0.005, 0.1}, std::nullopt}};

bool hasLabel(const Drawing& chart, const std::string& text) {
    return std::any_of(chart.labels.begin(), chart.labels.end(),
                       [&](const Drawing::Label& label) { return label.text == text; });
}

const Drawing::Label& labelOf(const Drawing& chart, const std::string& text) {
    return *std::find_if(chart.labels.begin(), chart.labels.end(),
                         [&](const Drawing::Label& label) { return label.text == text; });
}

void expectWithin(const Drawing& chart) {
    for (const Drawing::Dot& dot : chart.dots) {
        EXPECT_GE(dot.centre.x, 0);
        EXPECT_LE(dot.centre.x, chart.width);
        EXPECT_GE(dot.centre.y, 0);
        EXPECT_LE(dot.centre.y, chart.height);
    }
}

TEST(TimeChart, DrawsTheForceFromWhenTheFingerStands) {
    const Drawing chart = relaxationChart({fading});
    expectWithin(chart);
    EXPECT_EQ(chart.dots.size(), 3U + 1U) << "points, and one of the legend";
    EXPECT_TRUE(hasLabel(chart, "time, s"));
    EXPECT_TRUE(hasLabel(chart, "force, N"));
    EXPECT_TRUE(hasLabel(chart, "time constant 0.2 s")) << "when 1/e of the way is left";
    EXPECT_GT(labelOf(chart, "now").place.x, chart.width / 2) << "away from a curve that falls";
}

TEST(TimeChart, MarksThatLieCloseTogetherAreBothRead) {
    NamedTimeCurve other = fading;
    other.name = "before";
    other.curve.timeConstant = 0.21;
    const Drawing chart = relaxationChart({fading, other});
    EXPECT_GT(labelOf(chart, "time constant 0.21 s").place.y - labelOf(chart, "time constant 0.2 s").place.y,
              15);
}

TEST(TimeChart, DrawsTheDepthUnderAForce) {
    const Drawing chart = creepChart({sinking});
    expectWithin(chart);
    EXPECT_EQ(chart.dots.size(), 3U + 1U);
    EXPECT_TRUE(hasLabel(chart, "depth, mm"));
    EXPECT_LT(labelOf(chart, "before").place.x, chart.width / 2);
    EXPECT_LT(chart.dots[2].centre.y, chart.dots[1].centre.y) << "deeper lies higher";
}

TEST(TimeChart, ManyPointsAreALineWithoutDots) {
    NamedTimeCurve dense = sinking;
    for (int i = 0; i < 100; ++i)
        dense.curve.points.push_back({1 + 0.01 * i, 0.004, 0.1});
    EXPECT_EQ(creepChart({dense}).dots.size(), 1U);
}

TEST(TimeCsv, HasALineForEachPoint) {
    EXPECT_EQ(timeCsv({sinking}),
              "name,time_s,depth_m,force_n\nbefore,0,0,0.1\nbefore,0.5,0.003,0.1\nbefore,1,0.004,0.1\n");
}

} // namespace
} // namespace esm
