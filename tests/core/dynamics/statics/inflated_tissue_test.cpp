#include "core/dynamics/statics/inflated_tissue.h"

#include "core/dynamics/forces.h"
#include "core/dynamics/simulation.h"
#include "core/support/errors.h"
#include "tests/support/filled_ball.h"
#include "tests/support/sanitized.h"
#include "tests/support/simulation_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace esm {
namespace {

using Eigen::Vector3d;

constexpr tissue::Parameters softWall{30, 0.3, 1e-4};
const double softWallBears = tissue::mostPressure(softWall.springConstant);

/// A ball on tethers, which bear next to nothing.
TissueModel looseBall(int levels, const tissue::Fluid& fluid) {
    TissueModel model = tissue::filledBall(levels, softWall, fluid);
    for (std::uint32_t node = 0; node < model.mass.size(); ++node)
        model.tethers.push_back({node, 1e-4, 0.01});
    return model;
}

InflatedTissue inflatedTo(double pressure, const TissueModel& model) {
    return inflated(makeSpringSystem(model), tissue::pressing(pressure).pressures);
}

double meanDistance(const Vectors& positions) {
    double sum = 0;
    for (const Vector3d& position : positions)
        sum += position.norm();
    return sum / static_cast<double>(positions.size());
}

// Where the tension of a ball's wall is p·r/2. Next to bursting a little more or less tension is a wide way.
TEST(InflatedTissue, HasTheWidthOfLaplacesLaw) {
    const TissueModel model = looseBall(3, {});
    for (const double share : {1e-9, 0.05, 0.2, 0.5, 0.8, 0.95}) {
        const double wider = tissue::widthUnder(share) - 1, within = share > 0.9 ? 0.03 : 0.01;
        const InflatedTissue ball = inflatedTo(share * softWallBears, model);
        EXPECT_NEAR(meanDistance(ball.positions) / tissue::ballRadius - 1, wider, within * wider + 1e-7)
            << share;
    }
}

TEST(InflatedTissue, RestsWithoutAPressure) {
    const TissueModel model = looseBall(2, {1e4, 0});
    EXPECT_EQ(inflatedTo(0, model).positions, model.network->restPositions);
    EXPECT_EQ(inflated(makeSpringSystem(model), {}).positions, model.network->restPositions);
}

/// Longer than wide, with a waist, held at its lower end.
TissueModel gourd(const tissue::Fluid& fluid) {
    TriangleMesh mesh = tissue::sphereMesh(3, tissue::ballRadius);
    for (Vector3d& vertex : mesh.vertices) {
        const double height = vertex.z() / tissue::ballRadius;
        vertex.head<2>() *= 0.7 + 0.3 * height * height + 0.2 * height;
        vertex.z() *= 1.6;
    }
    TissueModel model = tissue::filled(mesh, softWall, fluid);
    for (std::uint32_t node = 0; node < mesh.vertices.size(); ++node)
        if (mesh.vertices[node].z() < -1.3 * tissue::ballRadius)
            model.fixedNodes.push_back(node);
        else if (node % 3 == 0)
            model.tethers.push_back({node, 0.5, 0.05});
    return model;
}

/// Where a run comes to rest under the same pressure.
Vectors simulatedRest(const TissueModel& model, double pressure) {
    Simulation simulation(model, withStep(Integrator::Implicit, 0.02));
    EXPECT_EQ(simulation.advance(tissue::pressing(pressure), 300), 300U) << simulation.failure();
    return simulation.positions();
}

TEST(InflatedTissue, RestsWhereASimulationComesTo) {
    if (isSanitized()) GTEST_SKIP() << "smaller bodies show the sanitizers the same";
    const double pressure = 0.5 * softWallBears;
    for (const double stiffness : {0.0, softWallBears}) {
        const TissueModel model = gourd({stiffness, pressure});
        const Vectors found = inflatedTo(pressure, model).positions,
                      expected = simulatedRest(model, pressure);
        double off = 0, moved = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            off = std::max(off, (found[i] - expected[i]).norm());
            moved = std::max(moved, (expected[i] - model.network->restPositions[i]).norm());
        }
        EXPECT_GT(moved, 0.1 * tissue::ballRadius) << stiffness;
        EXPECT_LT(off, 2e-3 * moved) << stiffness;
    }
}

TEST(InflatedTissue, BurstsWhereTheWallHoldsNoMoreAndSaysWhatItBears) {
    const TissueModel model = looseBall(2, {});
    EXPECT_NO_THROW(inflatedTo(0.97 * softWallBears, model));
    for (const double times : {1.05, 10.0, 1e6})
        try {
            inflatedTo(times * softWallBears, model);
            FAIL() << times;
        } catch (const InvalidModel& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr("bursts part 1 of the surface (number 0 in files)"))
                << times;
        }
    try {
        inflatedTo(2 * softWallBears, model);
        FAIL();
    } catch (const InvalidModel& error) {
        EXPECT_THAT(error.what(), testing::ContainsRegex("at least (48|49|50) % of this pressure"));
    }
}

TEST(InflatedTissue, ShrinksUnderSuctionOrSaysThatItDoesNotHold) {
    const TissueModel model = looseBall(2, {});
    EXPECT_LT(tissue::volumeOf(model, inflatedTo(-0.01 * softWallBears, model).positions),
              tissue::volumeOf(model, model.network->restPositions));
    try {
        for (const Vector3d& place : inflatedTo(-4 * softWallBears, model).positions)
            ASSERT_TRUE(place.allFinite());
    } catch (const InvalidModel& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("suction"));
    }
}

TEST(InflatedTissue, CanBeCancelled) {
    EXPECT_THROW(inflated(makeSpringSystem(looseBall(2, {})), tissue::pressing(0.8 * softWallBears).pressures,
                          [](double share) { return share < 0.1; }),
                 Cancelled);
}

} // namespace
} // namespace esm
