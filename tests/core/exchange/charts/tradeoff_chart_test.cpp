#include "core/exchange/charts/tradeoff_chart.h"

#include <gmock/gmock.h>

#include <limits>

using namespace esm;

namespace {

constexpr Stepping plainEuler{Integrator::Euler, 1e-4, Precision::Double};

TradeoffRun stableRun(const Stepping& stepping, double error, double wallPerSecond) {
    return {stepping, 812, true, error, false, wallPerSecond, {}};
}

/// Every method in every precision, two of which are best.
Tradeoff everyMethod() {
    Tradeoff tradeoff;
    double error = 0.1;
    for (const Integrator integrator : allIntegrators)
        for (const Precision precision : {Precision::Double, Precision::Float}) {
            error *= 0.7;
            tradeoff.runs.push_back(stableRun({integrator, 1e-3, precision}, error, 0.02 / error));
        }
    tradeoff.runs.back().coarser = Detail{Detail::Kind::Nodes, 200};
    recommend(tradeoff, {});
    return tradeoff;
}

bool isColoured(const Drawing::Line& line) {
    const auto& [red, green, blue] = line.colour;
    return red != green || green != blue;
}

std::vector<Drawing::Line> wishesOf(const Drawing& chart) {
    std::vector<Drawing::Line> lines;
    std::copy_if(chart.lines.begin(), chart.lines.end(), std::back_inserter(lines), isColoured);
    return lines;
}

std::ptrdiff_t countOf(const Drawing& chart, const std::string& words) {
    return std::count_if(chart.labels.begin(), chart.labels.end(),
                         [&](const Drawing::Label& label) { return label.text == words; });
}

} // namespace

TEST(TradeoffChart, LeavesOutWhatHasNoPlaceOnItsAxes) {
    Tradeoff tradeoff;
    tradeoff.runs = {stableRun(plainEuler, 0.01, 0.5), stableRun(plainEuler, 0.02, 0.2)};
    const std::size_t dots = tradeoffChart(tradeoff, {}).dots.size();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (const TradeoffRun& run :
         {stableRun(plainEuler, 0, 0.5), stableRun(plainEuler, infinite, 0.5), stableRun(plainEuler, 0.01, 0),
          stableRun(plainEuler, 0.01, infinite), TradeoffRun{plainEuler, 812, false, 0.01, false, 0.5, {}}}) {
        tradeoff.runs.push_back(run);
        EXPECT_EQ(tradeoffChart(tradeoff, {}).dots.size(), dots);
    }
    tradeoff.runs.push_back(stableRun(plainEuler, 0.03, 0.1));
    EXPECT_EQ(tradeoffChart(tradeoff, {}).dots.size(), dots + 1) << "one that has a place";
}

TEST(TradeoffChart, HasOneLineForEachWish) {
    const std::vector<Drawing::Line> wishes = wishesOf(tradeoffChart(everyMethod(), {}));
    ASSERT_EQ(wishes.size(), 2U);
    EXPECT_EQ(wishes[0].from.x, wishes[0].to.x) << "the speed";
    EXPECT_EQ(wishes[1].from.y, wishes[1].to.y) << "the error";
}

TEST(TradeoffChart, HasOneRingForEachWishThatSomeRunMeets) {
    Tradeoff tradeoff = everyMethod();
    ASSERT_TRUE(tradeoff.bestInRealTime && tradeoff.fastestToError);
    const std::size_t both = tradeoffChart(tradeoff, {}).dots.size();
    tradeoff.bestInRealTime.reset();
    EXPECT_EQ(tradeoffChart(tradeoff, {}).dots.size(), both - 1);
    tradeoff.fastestToError.reset();
    EXPECT_EQ(tradeoffChart(tradeoff, {}).dots.size(), both - 2);
}

TEST(TradeoffChart, NamesEachMeasuredMethodOnceByItsTitle) {
    Tradeoff tradeoff = everyMethod();
    for (const Integrator integrator : allIntegrators)
        EXPECT_EQ(countOf(tradeoffChart(tradeoff, {}), traitsOf(integrator).title), 1);
    tradeoff.runs = {stableRun(plainEuler, 0.01, 0.5), stableRun(plainEuler, 0.02, 0.2)};
    tradeoff.pareto.clear();
    tradeoff.bestInRealTime = tradeoff.fastestToError = std::nullopt;
    const Drawing chart = tradeoffChart(tradeoff, {});
    EXPECT_EQ(countOf(chart, traitsOf(Integrator::Euler).title), 1);
    EXPECT_EQ(countOf(chart, traitsOf(Integrator::Verlet).title), 0);
}

TEST(TradeoffChart, SaysTheWishesAsTheWindowDoes) {
    const Drawing chart = tradeoffChart(everyMethod(), {1, 0.01});
    for (const char* words : {"single precision", "real time", "1 % error", "on fewer nodes"})
        EXPECT_EQ(countOf(chart, words), 1) << words;
    EXPECT_EQ(countOf(tradeoffChart(everyMethod(), {2.5, 0.01}), "2.5 times real time"), 1);
}

TEST(TradeoffChart, HasRoomForItsLongestWords) {
    const Image picture = toImage(tradeoffChart(everyMethod(), {1.23456e-12, 1.23456e-12}));
    for (int y = 0; y < picture.height; ++y)
        for (const int x : {0, 1, picture.width - 2, picture.width - 1})
            ASSERT_EQ(picture.at(x, y)[1], 255) << "words are cut at " << x << ", " << y;
}

TEST(TradeoffChart, ItsScalesHaveRoomForTheirNumbersHoweverFarTheyReach) {
    const Drawing chart = tradeoffChart(everyMethod(), {1e12, 1e-12});
    std::vector<double> places;
    for (const Drawing::Label& label : chart.labels)
        if (label.anchor == Drawing::Anchor::Middle && label.text.find("time") == std::string::npos)
            places.push_back(label.place.x);
    ASSERT_GT(places.size(), 2U);
    for (std::size_t i = 1; i < places.size(); ++i)
        EXPECT_GT(places[i] - places[i - 1], 55) << "more than 0.0001 is wide";
}
