#include "core/exchange/charts/strip_chart.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

const std::vector<NamedStrip> strips{{"before", {{0, 0, 0}, {0.002, 0.04, 0.1}}},
                                     {"after", {{0, 0, 0}, {0.002, 0.05, 0.3}}}};

TEST(StripChart, DrawsForceOverElongation) {
    const Drawing chart = stripChart(strips);
    EXPECT_EQ(chart.dots.size(), 4U + 2U); // points, and one of the legend for each curve
    EXPECT_LT(chart.dots[1].centre.y, chart.dots[0].centre.y);
    EXPECT_GT(chart.dots[1].centre.x, chart.dots[0].centre.x);
}

TEST(StripCsv, HasALineForEachPoint) {
    EXPECT_EQ(stripCsv(strips), "name,elongation_m,strain,force_n\nbefore,0,0,0\nbefore,0.002,0.04,0.1\n"
                                "after,0,0,0\nafter,0.002,0.05,0.3\n");
}

} // namespace
} // namespace esm
