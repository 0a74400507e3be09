#include "core/dynamics/settling.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

/// Nodes in a row, joined by springs of 4 N/m and 0.1 N·s/m, each node of 0.01 kg.
TissueModel row(std::size_t nodes) {
    SpringNetwork network;
    for (std::size_t i = 0; i < nodes; ++i)
        network.restPositions.emplace_back(static_cast<double>(i), 0, 0);
    for (std::size_t i = 1; i < nodes; ++i)
        tissue::addSpring(network, i - 1, i);
    return tissue::model(std::move(network), {4, 0.1, 0.01});
}

} // namespace

TEST(Settling, TakesTheTimeOfAWaveToTheNearestHold) {
    TissueModel model = row(6);
    model.fixedNodes = {0};
    model.tethers = {{5, 1, 0.4}};
    const std::vector<Settling> settling = settlingOf(makeSpringSystem(model));
    const std::array waveTimes{0.0, 0.05, 0.1, 0.15, 0.15, 0.1}, driftTimes{0.0, 0.05, 0.05, 0.05, 0.5, 0.5};
    for (std::size_t i = 0; i < settling.size(); ++i) {
        EXPECT_NEAR(settling[i].waveTime, waveTimes[i], 1e-12) << i;
        EXPECT_NEAR(settling[i].driftTime, driftTimes[i], 1e-12) << i;
    }
}

TEST(Settling, TakesTheTimeOfTheSofterBranch) {
    TissueModel model = row(2);
    model.fixedNodes = {0};
    for (const auto& [factor, waveTime] : {std::pair{9.0, 0.05}, {0.25, 0.1}}) {
        model.stiffening = SpringStiffening{0.2, factor};
        EXPECT_NEAR(settlingOf(makeSpringSystem(model))[1].waveTime, waveTime, 1e-12);
    }
}

// The slowest motion of n nodes in a row, each with its drag d, takes (2n/π)²·d/c.
TEST(Settling, TakesTheTimeOfAllThatIsDraggedOnTheWay) {
    constexpr std::size_t dragged = 100;
    TissueModel model = row(dragged + 1);
    model.fixedNodes = {0};
    for (std::uint32_t node = 1; node <= dragged; ++node)
        model.tethers.push_back({node, 0, 2});
    const double slowest = std::pow(2 * dragged / 3.14159265358979, 2) * 2 / 4;
    const double found = settlingOf(makeSpringSystem(model)).back().driftTime;
    EXPECT_GT(found, slowest);
    EXPECT_LT(found, 1.3 * slowest);
}

TEST(Settling, TakesForEverWhereNothingHolds) {
    TissueModel model = row(3);
    model.tethers = {{1, 0, 0}};
    for (const Settling& settling : settlingOf(makeSpringSystem(model)))
        EXPECT_EQ(settling.waveTime, std::numeric_limits<double>::infinity());
}
