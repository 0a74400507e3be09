#include "core/model/wall_hinges.h"

#include "core/dynamics/hinge_force.h"
#include "tests/support/bent_walls.h"
#include "tests/support/flat_nets.h"

#include <gtest/gtest.h>

using namespace esm;
using namespace esm::test;
using Eigen::Vector3d;

namespace {

constexpr double thickness = 0.4;

double areaOf(const Triangle& t, const std::vector<Vector3d>& at) {
    return (at[t[1]] - at[t[0]]).cross(at[t[2]] - at[t[0]]).norm() / 2;
}

/// m², a third of each triangle for each hinge at it.
double shareOfHinges(const TriangleMesh& mesh, const TissueModel& wall) {
    double share = 0;
    for (const Hinge& hinge : wall.hinges)
        for (const std::size_t corner : {2U, 3U})
            share += areaOf({hinge.nodes[0], hinge.nodes[1], hinge.nodes[corner]}, mesh.vertices) / 3;
    return share;
}

/// The energy that a wall's hinges hold, rolled onto a wide cylinder, in parts of the plate's.
double stiffnessRolled(const TriangleMesh& mesh, double angle) {
    const TissueModel wall = wallOf(mesh, {10, 1, 1}, thickness);
    const SpringSystem system = makeSpringSystem(wall);
    const double radius = 2000;
    const Vectors places = rolled(mesh.vertices, radius, angle);
    double energy = 0;
    for (const auto& hinge : system.hinges)
        energy += elasticEnergy(hinge, ofNodes(hinge, places));
    const double plate = plateStiffness(10, thickness) / (2 * radius * radius);
    return energy / (plate * shareOfHinges(mesh, wall));
}

} // namespace

// D = E·t³/(12(1 − ν²)) by hand: of c = √3 N/m, E·t is 2 N/m.
TEST(PlateStiffness, FollowsFromSpringsAndThickness) {
    EXPECT_NEAR(plateStiffness(std::sqrt(3.0), 0.1), 2 * 0.01 / (12 * (1 - 1.0 / 9)), 1e-15);
}

TEST(WallHinges, OfTheRegularNetBendAsThePlateEveryWay) {
    const TriangleMesh mesh = regularNet(60, 60);
    for (const double degrees : {0.0, 17.0, 30.0, 45.0, 60.0, 90.0})
        EXPECT_NEAR(stiffnessRolled(mesh, degrees * M_PI / 180), 1, 0.012) << degrees;
}

TEST(WallHinges, OfUnevenNetsBendAsThePlateWithinTwoHundredths) {
    for (const double radius : {0.2, 0.4, 0.5})
        for (const double degrees : {0.0, 30.0, 60.0, 90.0})
            EXPECT_NEAR(stiffnessRolled(jittered(regularNet(40, 40), radius, 1), degrees * M_PI / 180), 1,
                        0.02)
                << radius << " " << degrees;
    for (const double degrees : {0.0, 45.0, 90.0})
        EXPECT_NEAR(stiffnessRolled(graded(regularNet(40, 40), 4), degrees * M_PI / 180), 1, 0.02);
}

// Not each way alike: along the long edges such triangles are stiffer, across them softer.
TEST(WallHinges, OfDrawnOutNetsBendAsThePlateInTheMeanOfAllWays) {
    const TriangleMesh mesh = drawnOut(regularNet(40, 40), 2);
    double sum = 0;
    for (int way = 0; way < 8; ++way)
        sum += stiffnessRolled(mesh, way * M_PI / 8) / 8;
    EXPECT_NEAR(sum, 1, 0.02);
}

TEST(WallHinges, OfATubeResistTheChangeOfItsCurvature) {
    const double radius = 6;
    const TriangleMesh sheet = regularNet(30, 30);
    TriangleMesh tube = sheet;
    tube.vertices = rolled(sheet.vertices, radius, 0);
    const TissueModel wall = wallOf(tube, {10, 1, 1}, thickness);
    const SpringSystem system = makeSpringSystem(wall);
    for (const double other : {5.0, 8.0, 1000.0, -6.0}) {
        const Vectors places = rolled(sheet.vertices, other, 0);
        double energy = 0;
        for (const auto& hinge : system.hinges)
            energy += elasticEnergy(hinge, ofNodes(hinge, places));
        const double change = 1 / other - 1 / radius;
        const double plate = plateStiffness(10, thickness) / 2 * change * change;
        EXPECT_NEAR(energy / (plate * shareOfHinges(sheet, wall)), 1, 0.03) << other;
    }
}

TEST(WallHinges, TakeTheMeanTissueOfTheirNodesAndItsTimeOfRelaxation) {
    const TriangleMesh mesh = regularNet(6, 6);
    TissueModel model = tissue::fromMesh(mesh, {10, 0.2, 1});
    const std::vector<Hinge> even = wallHinges(model, mesh.triangles, thickness);
    for (std::size_t node = 0; node < model.springConstant.size(); ++node) {
        model.springConstant[node] = 10 + static_cast<double>(node);
        model.viscosity[node] = 0.1 * static_cast<double>(node);
    }
    const std::vector<Hinge> graded = wallHinges(model, mesh.triangles, thickness);
    ASSERT_EQ(graded.size(), even.size());
    for (std::size_t i = 0; i < even.size(); ++i) {
        EXPECT_NEAR(even[i].viscosity / even[i].stiffness, 0.02, 1e-15);
        double mean = 0;
        for (const std::uint32_t node : even[i].nodes)
            mean += node / 4.0;
        EXPECT_NEAR(graded[i].stiffness / even[i].stiffness, (10 + mean) / 10, 1e-12);
        EXPECT_NEAR(graded[i].viscosity / graded[i].stiffness, 0.1 * mean / (10 + mean), 1e-12);
    }
}

TEST(WallHinges, AreNotWhereASurfaceEndsBranchesOrHasNoArea) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {2, 0, 0}};
    const auto count = [&](std::vector<Triangle> triangles) {
        const TissueModel model = tissue::fromMesh(mesh, {10, 1, 1});
        return wallHinges(model, triangles, thickness).size();
    };
    EXPECT_EQ(count({{0, 1, 2}}), 0U);
    EXPECT_EQ(count({{0, 1, 2}, {1, 0, 3}}), 1U);
    EXPECT_EQ(count({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}), 0U);
    EXPECT_EQ(count({{0, 1, 2}, {1, 0, 5}}), 0U);
    EXPECT_EQ(count({{0, 1, 2}, {1, 0, 2}}), 0U);
}
