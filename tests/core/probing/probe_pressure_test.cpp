#include "core/probing/strip.h"
#include "core/support/errors.h"
#include "tests/support/filled_ball.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace esm {
namespace {

using Eigen::Vector3d;

constexpr double balloonConstant = 30; ///< N/m
const double balloonBears = tissue::mostPressure(balloonConstant);

/// A ball, its lowest nodes fixed, under a share of the pressure that bursts it.
class BalloonProbe : public testing::Test {
protected:
    BalloonProbe() {
        settings.place = {0, 0, tissue::ballRadius};
        settings.radius = 0.5 * tissue::ballRadius;
        settings.depth = 0.2 * tissue::ballRadius;
        settings.steps = 4;
    }
    TissueModel balloon(double share) const {
        const double pressure = share * balloonBears;
        TissueModel model = tissue::filled(mesh, {balloonConstant, 0.3, 1e-4}, {0, pressure});
        model.cavities.front().initialPressure = pressure;
        for (std::uint32_t node = 0; node < mesh.vertices.size(); ++node) {
            if (mesh.vertices[node].z() < -0.8 * tissue::ballRadius)
                model.fixedNodes.push_back(node);
            else
                model.tethers.push_back({node, 0.5, 0.05});
        }
        return model;
    }
    ProbeResult result(double share) const { return probe({balloon(share), surface}, settings); }
    std::string problem(double share) const {
        try {
            result(share);
            return "";
        } catch (const InvalidModel& error) {
            return error.what();
        }
    }

    TriangleMesh mesh = tissue::sphereMesh(2, tissue::ballRadius);
    TouchedSurface surface{mesh.triangles};
    ProbeSettings settings;
};

TEST_F(BalloonProbe, FindsAnOrganFirmerTheHigherThePressureWithin) {
    double before = 0;
    for (const double share : {0.0, 0.2, 0.4, 0.6}) {
        const ProbeResult found = result(share);
        EXPECT_GT(found.curve.back().force, 1.1 * before) << share;
        if (share > 0) {
            EXPECT_GT(found.stiffness, found.stiffnessAtStart) << "depths count from where it first touches";
            EXPECT_GT(found.stiffnessAtStart, 0) << share;
        }
        EXPECT_EQ(found.place, settings.place) << "as the organ is drawn";
        before = found.curve.back().force;
    }
}

TEST_F(BalloonProbe, TellsHowThePartStandsUnderItsPressure) {
    EXPECT_TRUE(result(0).inflated.empty());
    const std::vector<InflatedPart> parts = result(0.5).inflated;
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].part, 0U);
    EXPECT_EQ(parts[0].pressure, 0.5 * balloonBears);
    EXPECT_NEAR(parts[0].restVolume, enclosedVolume(mesh), 1e-9 * parts[0].restVolume);
    EXPECT_NEAR(std::cbrt(parts[0].volume / parts[0].restVolume), tissue::widthUnder(0.5), 0.05)
        << "it is held below";
}

TEST_F(BalloonProbe, StandsOverThePlaceAsItIsUnderThePressure) {
    settings.place = tissue::ballRadius * Vector3d(0.9, 0, 0.43589);
    settings.direction = Vector3d(-1, 0, 0);
    EXPECT_LT((result(0).direction - Vector3d(-1, 0, 0)).norm(), 1e-12);
    settings.direction.reset();
    // Held below, the ball grows upwards: the place faces more to the side than before.
    EXPECT_LT(result(0.6).direction.z(), 0);
    EXPECT_GT(result(0.6).direction.z(), result(0).direction.z());
    settings.place = {0, 0, tissue::ballRadius};
    settings.depth = 2.1 * tissue::ballRadius;
    EXPECT_THAT(problem(0), testing::HasSubstr("press less deep")) << "thicker than it is at rest";
    settings.depth = 5 * tissue::ballRadius / 1.5;
    EXPECT_THAT(problem(0.8), testing::ContainsRegex("organ is (7[0-9]|8[0-9])[.0-9]* mm thick"));
}

TEST_F(BalloonProbe, RelaxesAndCreepsFromWhereItRestsUnderThePressure) {
    settings.relaxation = RelaxationTest{3};
    const ProbeResult pressed = result(0.5);
    const TimeCurve& relaxation = *pressed.relaxation;
    EXPECT_EQ(relaxation.points.front().force, 0);
    EXPECT_NEAR(relaxation.points.back().force, pressed.curve.back().force,
                0.01 * pressed.curve.back().force);
    settings.relaxation.reset();
    settings.creep = CreepTest{pressed.curve.back().force, 5};
    const TimeCurve creep = result(0.5).creep.value();
    EXPECT_NEAR(creep.end.depth, settings.depth, 2e-3 * settings.depth);
    EXPECT_NEAR(creep.points.back().depth, settings.depth, 0.01 * settings.depth);
    EXPECT_LT(creep.points[1].depth, 0.1 * settings.depth) << "it does not begin by swelling";
}

TEST_F(BalloonProbe, SaysWhatBurstsUnderThePressure) {
    EXPECT_THAT(problem(3), testing::HasSubstr("bursts part 1 of the surface"));
    EXPECT_THAT(problem(3), testing::HasSubstr("lower the pressure"));
    settings.place = {1, 0, 0};
    EXPECT_THAT(problem(3), testing::HasSubstr("off the organ's surface")) << "what is sooner known is said";
}

TEST_F(BalloonProbe, PullsTheSameStripUnderAPressure) {
    mesh = tissue::sphereMesh(3, tissue::ballRadius);
    surface = TouchedSurface(mesh.triangles);
    StripSettings strip;
    strip.place = settings.place;
    strip.length = 0.8 * tissue::ballRadius;
    strip.width = 0.6 * tissue::ballRadius;
    strip.steps = 2;
    EXPECT_EQ(pullStrip({balloon(0.9), surface}, strip).curve.back().force,
              pullStrip({balloon(0), surface}, strip).curve.back().force);
}

} // namespace
} // namespace esm
