#include "core/probing/strip.h"

#include "core/model/net_elasticity.h"
#include "core/project/shared_tissue.h"
#include "core/project/simulated_network.h"
#include "core/project/wall.h"
#include "core/solid/lattice_elasticity.h"
#include "core/support/errors.h"
#include "tests/support/bent_walls.h"
#include "tests/support/flat_nets.h"
#include "tests/support/solid_surfaces.h"
#include "tests/support/tissue_models.h"

#include <Eigen/Dense>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace esm {
namespace {

using Eigen::Vector3d;

constexpr double netConstant = 10;                            ///< N/m
const double sheetModulus = 2 * netConstant / std::sqrt(3.0); ///< N/m, of the regular net
constexpr double edge = 0.002;                                ///< m

/// Rolled about the y axis; what was the middle of its width lies at x = 0, z = 0.
TriangleMesh bent(TriangleMesh flat, double radius) {
    const double middle = boundingBox(flat.vertices).center().x();
    for (Vector3d& vertex : flat.vertices)
        vertex.x() -= middle;
    flat.vertices = test::rolled(flat.vertices, radius, 0);
    return flat;
}

TriangleMesh ofEdge(TriangleMesh net, double length) {
    for (Vector3d& vertex : net.vertices)
        vertex *= length;
    return net;
}

/// A sheet whose tissue is shared out over its springs.
struct Sheet {
    explicit Sheet(const TriangleMesh& flat) {
        SpringNetwork network = networkFromMesh(flat);
        network.sheet = sheetShares(network.restPositions, network.springs, flat.triangles);
        surface = TouchedSurface(flat.triangles);
        middle = boundingBox(flat.vertices).center();
        model = tissue::model(std::move(network), {netConstant, 0.1, 1e-4});
        model.ownValues = sharedValues(model, usualWallThickness);
    }
    StripResult pulled(const StripSettings& settings) const { return pullStrip({model, surface}, settings); }

    TissueModel model;
    TouchedSurface surface;
    Vector3d middle;
};

StripSettings stripAt(const Vector3d& place, const Vector3d& along) {
    StripSettings settings;
    settings.place = place;
    settings.along = along;
    settings.length = 0.05;
    settings.width = 0.015;
    settings.stretch = 0.01;
    settings.steps = 2;
    return settings;
}

TEST(Strip, TellsTheModulusOfARegularNetInAnyDirection) {
    const Sheet sheet(ofEdge(test::regularNet(40, 46), edge));
    for (const double angle : {0.0, 0.3, 0.5, M_PI / 2}) {
        const Vector3d along(std::cos(angle), std::sin(angle), 0);
        const StripResult result = sheet.pulled(stripAt(sheet.middle, along));
        ASSERT_TRUE(result.membraneStiffness);
        EXPECT_NEAR(*result.membraneStiffness, sheetModulus, 0.03 * sheetModulus) << angle;
        EXPECT_FALSE(result.youngsModulus) << "without a thickness";
    }
}

TEST(Strip, IsTurnedToTheLeft) {
    const Sheet sheet(ofEdge(test::regularNet(40, 46), edge));
    StripSettings settings = stripAt(sheet.middle, Vector3d::UnitX());
    settings.turn = M_PI / 2;
    EXPECT_LT((sheet.pulled(settings).along - Vector3d::UnitY()).norm(), 1e-9);
}

TEST(Strip, TellsTheModulusOfUnevenNets) {
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
        const Sheet sheet(ofEdge(test::jittered(test::regularNet(40, 46), 0.35, seed), edge));
        StripSettings settings = stripAt(sheet.middle, Vector3d(1, seed, 0));
        settings.wallThickness = 0.003;
        const StripResult result = sheet.pulled(settings);
        ASSERT_TRUE(result.membraneStiffness);
        EXPECT_NEAR(*result.membraneStiffness, sheetModulus, 0.08 * sheetModulus) << seed;
        EXPECT_NEAR(*result.youngsModulus, *result.membraneStiffness / 0.003, 1e-9);
    }
}

TissueModel filledModel(const TriangleMesh& mesh, const LatticeFilling& filling) {
    SpringNetwork network = networkOf(mesh, {Detail::Kind::Filled, 0, filling});
    TissueModel model = tissue::model(std::move(network), {netConstant, 0.1, 1e-4});
    model.ownValues = sharedValues(model, usualWallThickness);
    return model;
}

/// Along the edges of a lattice's cubes, over that of the solid it stands for: of diamond, which is twice as
/// stiff in shear along the cube's faces as across, less.
double modulusAlongCube(LatticeKind kind) {
    return 1 / elasticityOf(kind).tensor.inverse()(0, 0) / relativeModulus(kind);
}

/// Cut out of a lattice, so that its faces are steps of cells.
TEST(Strip, TellsTheModulusOfLattices) {
    const TriangleMesh mesh = test::block({-0.04, -0.02, -0.02}, {0.04, 0.02, 0});
    const double modulus = youngsModulusOfWall(netConstant, usualWallThickness);
    for (const LatticeKind kind : {LatticeKind::BodyCentred, LatticeKind::Cubic, LatticeKind::Diamond}) {
        const TissueModel model = filledModel(mesh, LatticeFilling{kind, 0.003});
        const StripSettings settings = stripAt(Vector3d::Zero(), Vector3d::UnitX());
        const StripResult result = pullStrip({model, touchedSurface(mesh, *model.network)}, settings);
        ASSERT_TRUE(result.youngsModulus);
        const double expected = modulusAlongCube(kind) * modulus;
        EXPECT_NEAR(*result.youngsModulus, expected, 0.07 * expected) << wordOf(kind);
        EXPECT_FALSE(result.membraneStiffness);
    }
}

/// Along a tube's axis. The wall is as stiff as its surface has area, and lies around it: its volume is
/// larger.
TEST(Strip, TellsTheModulusOfAWallOfPrisms) {
    constexpr double radius = 0.04, wall = 0.002; // m
    const TriangleMesh tube = bent(ofEdge(test::regularNet(40, 46), edge), radius);
    const TissueModel model = filledModel(tube, LatticeFilling{LatticeKind::Prisms, 0, wall, 2});
    const double modulus = youngsModulusOfWall(netConstant, usualWallThickness) / (1 + wall / (2 * radius));
    const Vector3d middle(0, boundingBox(tube.vertices).center().y(), 0);
    const StripResult result =
        pullStrip({model, touchedSurface(tube, *model.network)}, stripAt(middle, Vector3d::UnitY()));
    ASSERT_TRUE(result.youngsModulus);
    EXPECT_NEAR(*result.youngsModulus, modulus, 0.05 * modulus);
}

/// The clamps' way straightens it; what it then stretches by, the gauge tells.
TEST(Strip, OfABentWallIsStraightenedFirst) {
    constexpr double radius = 0.04;
    const Sheet sheet(bent(ofEdge(test::regularNet(40, 46), edge), radius));
    StripSettings settings = stripAt(Vector3d(0, sheet.middle.y(), 0), Vector3d::UnitX());
    settings.stretch = 0.15;
    settings.steps = 15;
    const StripResult result = sheet.pulled(settings);
    EXPECT_EQ(result.curve[2].force, 0) << "it hangs loosely";
    EXPECT_EQ(result.curve[2].strain, 0);
    EXPECT_LT(result.curve.back().strain, 0.8 * settings.stretch);
    ASSERT_TRUE(result.membraneStiffness);
    EXPECT_NEAR(*result.membraneStiffness, sheetModulus, 0.1 * sheetModulus);
}

TEST(Strip, IsOfTheTissueWhereItIsCut) {
    Sheet sheet(ofEdge(test::regularNet(40, 46), edge));
    for (std::size_t i = 0; i < sheet.model.ownValues.size(); ++i)
        if (sheet.model.network->restPositions[sheet.model.network->springs[i].first].y() > sheet.middle.y())
            sheet.model.ownValues[i].springConstant *= 3;
    StripSettings settings = stripAt(sheet.middle, Vector3d::UnitX());
    settings.place.y() += 0.012;
    EXPECT_NEAR(sheet.pulled(settings).membraneStiffness.value(), 3 * sheetModulus, 0.1 * sheetModulus);
    settings.place.y() -= 0.024;
    EXPECT_NEAR(sheet.pulled(settings).membraneStiffness.value(), sheetModulus, 0.03 * sheetModulus);
}

/// Nothing holds the organ, or all of it: a strip is cut out all the same.
TEST(Strip, LeavesBehindWhatHoldsTheOrgan) {
    Sheet sheet(ofEdge(test::regularNet(40, 46), edge));
    const StripSettings settings = stripAt(sheet.middle, Vector3d::UnitX());
    const double free = sheet.pulled(settings).curve.back().force;
    EXPECT_GT(free, 0);
    for (std::uint32_t node = 0; node < sheet.model.mass.size(); ++node) {
        sheet.model.tethers.push_back({node, 100, 1});
        sheet.model.fixedNodes.push_back(node);
    }
    EXPECT_EQ(sheet.pulled(settings).curve.back().force, free);
}

/// Of a flat sheet.
class RefusedStrip : public testing::Test {
protected:
    std::string problem(const StripSettings& wrong) const {
        try {
            sheet.pulled(wrong);
            return "";
        } catch (const InvalidModel& error) {
            return error.what();
        }
    }
    Sheet sheet{ofEdge(test::regularNet(40, 46), edge)};
    StripSettings settings = stripAt(sheet.middle, Vector3d::UnitX());
};

TEST_F(RefusedStrip, IsNoTest) {
    const auto refused = [&](auto StripSettings::*field, auto value, const char* naming) {
        StripSettings wrong = settings;
        wrong.*field = value;
        EXPECT_THAT(problem(wrong), testing::HasSubstr(naming));
    };
    refused(&StripSettings::length, 0.0, "length");
    refused(&StripSettings::width, std::nan(""), "width");
    refused(&StripSettings::stretch, 1.5, "twice its length");
    refused(&StripSettings::steps, 0, "1 to 1000 steps");
    refused(&StripSettings::wallThickness, 0.0, "thickness");
    refused(&StripSettings::length, 3.0, "mm large");
    refused(&StripSettings::length, 0.1, "ends before a strip of 100 mm");
    refused(&StripSettings::length, 0.006, "nodes lie 2 mm apart");
    refused(&StripSettings::width, 0.0001, "at least 4 mm wide");
    refused(&StripSettings::along, Vector3d(0, 0, 1), "along the organ's surface");
    refused(&StripSettings::along, Vector3d(0, 0, 0), "along the organ's surface");
    refused(&StripSettings::place, Vector3d(0, 0, 1), "off the organ's surface");
}

TEST_F(RefusedStrip, HasNothingThatResists) {
    for (SpringValues& values : sheet.model.ownValues)
        values.springConstant = 0;
    EXPECT_THAT(problem(settings), testing::HasSubstr("constant of 0 N/m"));
}

TEST_F(RefusedStrip, HasNothingToStretch) {
    sheet.surface = TouchedSurface();
    EXPECT_THAT(problem(settings), testing::HasSubstr("no surface"));
    sheet.surface.body = TouchedSurface::Body{{}, {0, 1}, Vector3d::Zero(), Vector3d::UnitX()};
    EXPECT_THAT(problem(settings), testing::HasSubstr("one stiff piece"));
}

TEST_F(RefusedStrip, CanBeCancelled) {
    EXPECT_THROW(pullStrip({sheet.model, sheet.surface}, settings, [](double done) { return done < 0.3; }),
                 Cancelled);
}

} // namespace
} // namespace esm
