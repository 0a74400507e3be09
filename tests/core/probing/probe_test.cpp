#include "core/probing/probe.h"

#include "core/project/project.h"
#include "core/project/shared_tissue.h"
#include "core/project/simulated_network.h"
#include "core/project/wall.h"
#include "core/samples/samples.h"
#include "core/support/errors.h"
#include "tests/support/elastic_block.h"
#include "tests/support/sanitized.h"
#include "tests/support/solid_surfaces.h"
#include "tests/support/tethered_triangle.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace esm {
namespace {

using Eigen::Vector3d;

constexpr double springConstant = 10;                             ///< N/m
constexpr double blockWidth = 0.06, blockHeight = blockWidth / 2; ///< m
constexpr double fingerRadius = 0.06, pressedDepth = 0.002;       ///< m: a contact radius of 11 mm

/// A block filled with a lattice, its lower face fixed, its upper one at z = 0.
struct FilledBlock {
    TissueModel model;
    TouchedSurface surface;
};
/// @param width (m), twice the height
FilledBlock filledBlock(LatticeKind kind, double spacing, double width = blockWidth) {
    const double height = width / 2;
    const TriangleMesh mesh = test::block({-width / 2, -width / 2, -height}, {width / 2, width / 2, 0});
    const auto network = std::make_shared<const SpringNetwork>(
        networkOf(mesh, {Detail::Kind::Filled, 0, LatticeFilling{kind, spacing}}));
    FilledBlock block{tissue::model(*network, {springConstant, 0.1, 1e-3}), touchedSurface(mesh, *network)};
    block.model.ownValues = sharedValues(block.model, usualWallThickness);
    for (std::uint32_t node = 0; node < network->restPositions.size(); ++node)
        if (network->restPositions[node].z() < -height + 1e-6) block.model.fixedNodes.push_back(node);
    return block;
}

double forceOn(const FilledBlock& block) {
    ProbeSettings settings;
    settings.place = Vector3d::Zero();
    settings.radius = fingerRadius;
    settings.depth = pressedDepth;
    settings.steps = 1;
    return probe({block.model, block.surface}, settings).curve.back().force;
}

TEST(Probe, FindsALatticeAsFirmAsTheSolidThatItStandsFor) {
    if (isSanitized()) GTEST_SKIP() << "smaller bodies show the sanitizers the same";
    test::PressedBlock solid(
        {blockWidth / 2, blockHeight, youngsModulusOfWall(springConstant, 0.003), 0.25, 14});
    const double force = solid.force(fingerRadius, pressedDepth);
    EXPECT_NEAR(forceOn(filledBlock(LatticeKind::BodyCentred, 0.0036)), force, 0.1 * force);
}

TEST(Probe, FindsLatticesOfAnySpacingEquallyFirm) {
    if (isSanitized()) GTEST_SKIP() << "smaller bodies show the sanitizers the same";
    constexpr double width = 0.044; // m: four contact radii, of which each spacing has three or more
    const auto force = [&](double spacing) {
        return forceOn(filledBlock(LatticeKind::BodyCentred, spacing, width));
    };
    const double fine = force(0.003);
    for (const double spacing : {0.0036, 0.0033})
        EXPECT_NEAR(force(spacing), fine, 0.05 * fine) << spacing;
}

/// Of prisms, fixed below: a dent can be deeper than the wall is thick.
TEST(Probe, DentsAHollowBallDeeperThanItsWallIsThick) {
    constexpr double radius = 0.03, wall = 0.002; // m
    const TriangleMesh mesh = test::ball(radius, Vector3d::Zero(), 12);
    const auto network = std::make_shared<const SpringNetwork>(
        networkOf(mesh, {Detail::Kind::Filled, 0, LatticeFilling{LatticeKind::Prisms, 0, wall, 2}}));
    TissueModel model = tissue::model(*network, {springConstant, 0.1, 1e-3});
    model.ownValues = sharedValues(model, wall);
    for (std::uint32_t node = 0; node < network->restPositions.size(); ++node)
        if (network->restPositions[node].z() < 0) model.fixedNodes.push_back(node);
    const TouchedSurface surface = touchedSurface(mesh, *network);
    ProbeSettings settings;
    settings.place = Vector3d(0, 0, radius);
    settings.radius = 0.015;
    settings.depth = 2 * wall;
    settings.steps = 2;
    const ProbeResult dented = probe({model, surface}, settings);
    EXPECT_GT(dented.curve.back().force, dented.curve[1].force);
    settings.depth = 2 * radius - 1.5 * wall; // the inner side would meet the other wall
    try {
        probe({model, surface}, settings);
        FAIL();
    } catch (const InvalidModel& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("one side through the other"));
    }
}

TEST(Probe, TellsTheModulusThatHertzGives) {
    const double force = hertzForce(4000, 0.25, 0.01, 0.002);
    EXPECT_NEAR(force, 4.0 / 3 * 4000 / (1 - 0.0625) * 0.1 * std::pow(0.002, 1.5), 1e-12);
    EXPECT_NEAR(hertzModulus({0.002, force}, 0.25, 0.01), 4000, 1e-9);
}

/// Of the triangle on its tethers.
class TriangleProbe : public testing::Test {
protected:
    TriangleProbe() { settings.place = Vector3d::Zero(); }
    ProbeResult result() const { return probe({model, surface}, settings); }
    std::string problem() const {
        try {
            result();
            return "";
        } catch (const InvalidModel& error) {
            return error.what();
        }
    }

    TissueModel model = test::tetheredTriangle();
    TouchedSurface surface{test::largeTriangle().triangles};
    ProbeSettings settings;
};

TEST_F(TriangleProbe, PressesAcrossTheSurface) {
    const ProbeResult found = result();
    EXPECT_LT((found.direction + Vector3d::UnitZ()).norm(), 1e-12);
    EXPECT_EQ(found.curve.size(), 11U);
    EXPECT_EQ(found.curve.front().force, 0);
    EXPECT_NEAR(found.stiffnessAtStart, 3 * test::tetherConstant, 0.06);
    EXPECT_NEAR(found.stiffness, 3 * test::tetherConstant, 0.5);
    EXPECT_NEAR(found.poissonsRatio, 1.0 / 3, 1e-12);
}

TEST_F(TriangleProbe, TellsHowLongItCreeps) {
    settings.creep = CreepTest{0.2, 1};
    const TimeCurve creep = result().creep.value();
    const double time = test::tetherViscosity / test::tetherConstant;
    ASSERT_TRUE(creep.timeConstant);
    EXPECT_NEAR(*creep.timeConstant, time, 0.03 * time);
    EXPECT_NEAR(creep.end.depth, 0.2 / (3 * test::tetherConstant), 1e-3 * creep.end.depth);
    EXPECT_EQ(creep.points.back().time, 1);
}

TEST_F(TriangleProbe, ComesToTheForceAtRestWhereTheFingerStays) {
    settings.relaxation = RelaxationTest{1};
    const ProbeResult found = result();
    const TimeCurve relaxation = found.relaxation.value();
    EXPECT_EQ(relaxation.end.force, found.curve.back().force);
    EXPECT_NEAR(relaxation.points.back().force, relaxation.end.force, 2e-3 * relaxation.end.force)
        << "both to a thousandth";
    const auto isLess = [](const TimedPress& a, const TimedPress& b) { return a.force < b.force; };
    EXPECT_GT(std::max_element(relaxation.points.begin(), relaxation.points.end(), isLess)->force,
              1.5 * relaxation.end.force)
        << "dampers resist the finger on its way";
}

TEST_F(TriangleProbe, RefusesWhatIsNoTest) {
    const auto refused = [&](const ProbeSettings& wrong, const char* naming) {
        settings = wrong;
        EXPECT_THAT(problem(), testing::HasSubstr(naming));
    };
    const ProbeSettings right = settings;
    ProbeSettings wrong = right;
    wrong.radius = 0;
    refused(wrong, "radius");
    wrong = right;
    wrong.depth = std::nan("");
    refused(wrong, "depth");
    wrong = right;
    wrong.steps = 0;
    refused(wrong, "1 to 1000 steps");
    wrong = right;
    wrong.place = {0, 0, 0.1};
    refused(wrong, "100 mm off the organ's surface");
    wrong = right;
    wrong.direction = Vector3d::UnitZ();
    refused(wrong, "out of the organ");
    wrong = right;
    wrong.direction = Vector3d::Zero();
    refused(wrong, "direction");
    wrong = right;
    wrong.relaxation = RelaxationTest{0.01};
    refused(wrong, "relaxation");
    wrong = right;
    wrong.creep = CreepTest{0, 1};
    refused(wrong, "creep");
    wrong.creep = CreepTest{1, 1e-300};
    refused(wrong, "0.000001 s");
}

TEST_F(TriangleProbe, RefusesWhatCannotBePressed) {
    model.fixedNodes = {0, 1, 2};
    EXPECT_THAT(problem(), testing::HasSubstr("every node is fixed"));
    model.fixedNodes.clear();
    model.tethers.clear();
    EXPECT_THAT(problem(), testing::HasSubstr("nothing holds the organ"));
    surface = TouchedSurface();
    EXPECT_THAT(problem(), testing::HasSubstr("no surface"));
    surface.body = TouchedSurface::Body{{}, {0, 1}, Vector3d::Zero(), Vector3d::UnitX()};
    EXPECT_THAT(problem(), testing::HasSubstr("one stiff piece"));
}

TEST(Probe, RefusesToPressThroughTheOrgan) {
    const FilledBlock block = filledBlock(LatticeKind::BodyCentred, 0.008);
    ProbeSettings settings;
    settings.place = Vector3d::Zero();
    settings.depth = 0.031;
    try {
        probe({block.model, block.surface}, settings);
        FAIL();
    } catch (const InvalidModel& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("30 mm thick"));
    }
}

// Places at which a surface that bends freely snaps through, or leaves the finger next to no force: the
// search for balance must not depend on how the press is divided.
TEST(Probe, PressesASoftLiverByLittle) {
    if (isSanitized()) GTEST_SKIP() << "smaller bodies show the sanitizers the same";
    const Project liver = makeSample("liver");
    const TissueModel model = evaluateModel(liver);
    const TouchedSurface surface = touchedSurface(*liver.mesh, *liver.network);
    for (const Vector3d& place :
         {Vector3d(-0.00291750116, -0.00812230166, 0.0477734199), Vector3d(0.02, 0, 0.047)})
        for (const int steps : {1, 10}) {
            ProbeSettings settings;
            settings.place = place;
            settings.depth = 0.0005;
            settings.steps = steps;
            const double force = probe({model, surface}, settings).curve.back().force;
            EXPECT_GT(force, 1e-5) << place.transpose() << ", steps " << steps;
            EXPECT_LT(force, 1e-3) << place.transpose() << ", steps " << steps;
        }
}

/// A ball on tethers, with a fluid in it.
TissueModel filledBall(const TriangleMesh& ball, double stiffness) {
    TissueModel model = tissue::fromMesh(ball, {20, 1, 1e-3});
    for (std::uint32_t node = 0; node < ball.vertices.size(); ++node)
        model.tethers.push_back({node, 4, 0.2});
    model.cavities = {cavityOf(ball.vertices, ball.triangles, 0)};
    model.cavities.front().stiffness = stiffness;
    return model;
}

TEST(Probe, FindsABallFirmerTheStifferItsFluid) {
    const TriangleMesh ball = tissue::sphereMesh(3, 0.05);
    const TouchedSurface surface{ball.triangles};
    ProbeSettings settings;
    settings.place = {0, 0, 0.05};
    settings.radius = 0.02;
    settings.steps = 2;
    double before = 0;
    for (const double stiffness : {10.0, 1e4, 1e7}) {
        const double force = probe({filledBall(ball, stiffness), surface}, settings).curve.back().force;
        EXPECT_GT(force, before) << stiffness;
        before = force;
    }
}

/// Tissue without stiffness is as good as fixed, and what lies beside it is pressed all the same.
TEST(Probe, PressesBesideTissueWithoutStiffness) {
    const TriangleMesh ball = tissue::sphereMesh(3, 0.05);
    TissueModel model = tissue::fromMesh(ball, {20, 1, 1e-3});
    for (std::uint32_t node = 0; node < ball.vertices.size(); ++node) {
        if (ball.vertices[node].x() > 0.02)
            model.springConstant[node] = 0;
        else
            model.tethers.push_back({node, 4, 0.2});
    }
    ProbeSettings settings;
    settings.place = {0, 0, 0.05};
    settings.radius = 0.025;
    settings.depth = 0.002;
    settings.steps = 2;
    EXPECT_GT(probe({model, TouchedSurface(ball.triangles)}, settings).curve.back().force, 0);
}

TEST(Probe, TellsOfFixedNodesThatTheFingerMeets) {
    FilledBlock block = filledBlock(LatticeKind::BodyCentred, 0.005);
    ProbeSettings settings;
    settings.place = Vector3d::Zero();
    settings.radius = fingerRadius;
    settings.depth = pressedDepth / 2;
    settings.steps = 2;
    EXPECT_FALSE(probe({block.model, block.surface}, settings).meetsFixed);
    const auto& nodes = block.model.network->restPositions;
    for (std::uint32_t node = 0; node < nodes.size(); ++node)
        if (nodes[node].x() > 0.006 && nodes[node].z() > -1e-6) block.model.fixedNodes.push_back(node);
    std::sort(block.model.fixedNodes.begin(), block.model.fixedNodes.end());
    EXPECT_TRUE(probe({block.model, block.surface}, settings).meetsFixed);
}

TEST_F(TriangleProbe, CanBeCancelled) {
    EXPECT_THROW(probe({model, surface}, settings, [](double fraction) { return fraction < 0.3; }),
                 Cancelled);
}

} // namespace
} // namespace esm
