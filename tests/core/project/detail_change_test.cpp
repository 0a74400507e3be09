#include "core/project/detail_change.h"

#include "core/dynamics/measure/scene_run.h"
#include "core/support/errors.h"
#include "tests/support/solid_surfaces.h"
#include "tests/support/test_surfaces.h"
#include "tests/support/tissue_models.h"
#include "tests/support/was_touched.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace esm;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

using Points = std::vector<Eigen::Vector3d>;

Project organ(const TriangleMesh& mesh, const Detail& detail) {
    return makeProject("organ", {mesh, {}}, 0.5, detail);
}

/// A uterus-like body 7 cm high, off the origin.
TriangleMesh body() {
    TriangleMesh mesh = tissue::sphereMesh(3, 1);
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex = Eigen::Vector3d(0.02 * vertex.x(), 0.035 * vertex.y(), 0.015 * vertex.z()) +
                 Eigen::Vector3d(0.1, 0.2, -0.05);
    return mesh;
}

/// The largest change of a distance between two of the points, relative.
double distortion(const Points& before, const Points& after) {
    double most = 0;
    for (std::size_t i = 0; i < before.size(); i += 7)
        for (std::size_t j = i + 1; j < before.size(); j += 11) {
            const double was = (before[i] - before[j]).norm(), is = (after[i] - after[j]).norm();
            most = std::max(most, std::abs(is - was) / was);
        }
    return most;
}

} // namespace

TEST(Detail, MakesFewerNodesUnderTheWholeDrawnMesh) {
    const TriangleMesh mesh = lumpySurface(40, 80);
    const Project project = organ(mesh, {Detail::Kind::Nodes, 300});
    EXPECT_THAT(validate(project), IsEmpty());
    EXPECT_EQ(project.network->restPositions.size(), 300U);
    EXPECT_EQ(project.mesh->vertices.size(), mesh.vertices.size());
    EXPECT_EQ(detailOf(*project.network).kind, Detail::Kind::Nodes);
    EXPECT_EQ(detailOf(*project.network).nodes, 300U);
    EXPECT_EQ(simulatedSurface(*project.mesh, *project.network).size(), 596U);
    EXPECT_EQ(detailOf(*organ(mesh, {}).network).kind, Detail::Kind::EveryVertex);
    EXPECT_EQ(detailOf(*organ(mesh, {Detail::Kind::Nodes, mesh.vertices.size()}).network).kind,
              Detail::Kind::EveryVertex);
}

TEST(Detail, HoldsAndMovesLikeTheFullOrgan) {
    const TriangleMesh mesh = lumpySurface(40, 80);
    const Project full = organ(mesh, {}), fewer = organ(mesh, {Detail::Kind::Nodes, 600});
    EXPECT_EQ(fewer.base.mass, full.base.mass);
    const auto held = [](const Project& project) {
        double sum = 0;
        for (const Tether& tether : evaluateModel(project).tethers)
            sum += tether.springConstant;
        return sum;
    };
    EXPECT_NEAR(held(fewer) / held(full), 1, 0.3);
}

TEST(Detail, SaysWhenASurfaceCannotBeMadeAsCoarse) {
    TriangleMesh crumbs;
    for (std::uint32_t i = 0; i < 5; ++i) {
        for (const Eigen::Vector3d& corner : {Eigen::Vector3d(0, 0, 0), {1, 0, 0}, {0, 1, 0}})
            crumbs.vertices.emplace_back(corner + 3.0 * i * Eigen::Vector3d::UnitZ());
        crumbs.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const Project project = organ(crumbs, {Detail::Kind::Nodes, 6});
    EXPECT_EQ(project.network->restPositions.size(), 15U);
    EXPECT_THAT(project.importReport->warnings,
                Contains(HasSubstr("6 nodes were asked for, but the surface keeps 15")));
    EXPECT_THROW(organ(crumbs, {Detail::Kind::Nodes, 3}), InvalidModel);
    EXPECT_THROW(organ(crumbs, {Detail::Kind::Nodes, 16}), InvalidModel);
}

TEST(RigidDetail, IsThePublishedModelInsideTheOrgan) {
    const Project project = organ(body(), {Detail::Kind::Rigid, 0});
    EXPECT_THAT(validate(project), IsEmpty());
    const SpringNetwork& network = *project.network;
    ASSERT_EQ(network.restPositions.size(), 8U);
    EXPECT_EQ(network.springs.size(), 7U);
    EXPECT_EQ(detailOf(network).kind, Detail::Kind::Rigid);
    const TissueModel model = evaluateModel(project);
    EXPECT_EQ(model.fixedNodes.size(), 6U);
    EXPECT_THAT(model.tethers, IsEmpty());
    EXPECT_DOUBLE_EQ(model.mass[0], 0.5 / 8);
    EXPECT_EQ(valuesOf(model, 3).springConstant, 81.3091);
    EXPECT_EQ(valuesOf(model, 3).viscosity, 6);
    const Eigen::Vector3d middle = (network.restPositions[0] + network.restPositions[1]) / 2;
    EXPECT_LT((middle - Eigen::Vector3d(0.1, 0.2, -0.05)).norm(), 1e-9);
    EXPECT_NEAR((network.restPositions[0] - middle).y(), 0.015, 1e-4);
}

TEST(RigidDetail, FollowsTheMiddleAndTheDirectionOfTheLineBetweenTheInnerNodes) {
    const Project project = organ(body(), {Detail::Kind::Rigid, 0});
    Points positions = project.network->restPositions;
    const auto drawn = [&] { return drawnPositions(*project.mesh, *project.network, positions); };
    EXPECT_LT(distortion(project.mesh->vertices, drawn()), 1e-13);
    positions[0] += Eigen::Vector3d(0.01, 0.001, 0.002);
    positions[1] += Eigen::Vector3d(-0.004, 0.002, 0.003);
    const Points after = drawn();
    EXPECT_LT(distortion(project.mesh->vertices, after), 1e-12);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : after)
        middle += point / static_cast<double>(after.size());
    EXPECT_LT((middle - (positions[0] + positions[1]) / 2).norm(), 1e-4);
    // The top of the organ lies on the line, above the upper node.
    const auto top = static_cast<std::size_t>(
        std::max_element(project.mesh->vertices.begin(), project.mesh->vertices.end(),
                         [](const auto& a, const auto& b) { return a.y() < b.y(); }) -
        project.mesh->vertices.begin());
    const Eigen::Vector3d direction = (positions[0] - positions[1]).normalized();
    EXPECT_LT((after[top] - middle).cross(direction).norm(), 2e-3);
    EXPECT_GT((after[top] - middle).dot(direction), 0.03);
    positions[1] = positions[0]; // no direction is left
    for (const Eigen::Vector3d& point : drawn())
        ASSERT_TRUE(point.allFinite());
}

/// Pushed aside at its upper node by 0.3 N for half a second, as the sample is: it moves and turns as a
/// whole, and comes back.
TEST(RigidDetail, MovesAsAWholeWithThePublishedParameters) {
    const Project project = organ(body(), {Detail::Kind::Rigid, 0});
    Scene scene = project.scene;
    scene.duration = 1.5;
    scene.forces.push_back({0, {0, 0, -0.3}, 0, 0.5});
    scene.record.every = 0.05;
    double farthest = 0, last = 0;
    const auto sink = [&](double, const Points& positions) {
        const Points now = drawnPositions(*project.mesh, *project.network, positions);
        EXPECT_LT(distortion(project.mesh->vertices, now), 1e-12);
        last = 0;
        for (std::size_t i = 0; i < now.size(); ++i)
            last = std::max(last, (now[i] - project.mesh->vertices[i]).norm());
        farthest = std::max(farthest, last);
    };
    const TissueModel model = evaluateModel(project, scene);
    const SceneOutcome outcome = runScene({model, {}, scene}, sink);
    EXPECT_TRUE(outcome.stable) << outcome.outcome;
    EXPECT_GT(farthest, 0.001);
    EXPECT_LT(farthest, 0.03);
    EXPECT_LT(last, 0.5 * farthest);
}

/// A round instrument comes from the side, above the middle: nothing of the drawn surface may be left inside
/// it.
TEST(RigidDetail, IsPushedAsAWholeByAnInstrument) {
    const Project project = organ(body(), {Detail::Kind::Rigid, 0});
    const auto& rest = project.mesh->vertices;
    Simulation simulation(evaluateModel(project), {}, touchedSurface(*project.mesh, *project.network));
    Points drawn;
    for (int i = 0; i <= 60; ++i) {
        Loads loads;
        loads.instruments = {sphereAt(Eigen::Vector3d(0.14 - 0.0005 * i, 0.22, -0.05), 0.01)};
        ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
        drawn = drawnPositions(*project.mesh, *project.network, simulation.positions());
        for (const Eigen::Vector3d& point : drawn)
            ASSERT_GT((point - loads.instruments[0].pose.place).norm(),
                      0.99 * radiusOf(loads.instruments[0].shape))
                << i;
    }
    EXPECT_TRUE(wasTouched(simulation));
    EXPECT_LT(distortion(rest, drawn), 1e-12);
    double mean = 0, top = 0, bottom = 0;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        const double way = drawn[i].x() - rest[i].x();
        mean += way / static_cast<double>(rest.size());
        (rest[i].y() > 0.22 ? top : bottom) = std::min(way, rest[i].y() > 0.22 ? top : bottom);
    }
    EXPECT_LT(mean, -0.003);
    EXPECT_LT(top, bottom); // it turns about its middle
}

TEST(WithDetail, KeepsTheHoldOnTheSurroundingsAndWhatTheSceneSays) {
    const TriangleMesh mesh = lumpySurface(30, 60);
    Project full = organ(mesh, {});
    full.scene.tethers = {{3, 2.4, 10.7}};
    full.scene.forces = {{700, {0, 0, 1}, 0, 1}};
    full.scene.moves = {{10, {{0, {0, 0, 0}}}}, {11, {{0, {0, 0, 1}}}}};
    full.scene.record.nodes = std::vector<std::uint32_t>{5, 700};
    full.base.stiffening = SpringStiffening{0.2, 5};
    full.base.resistsBending = true;
    full.base.wallThickness = 0.004;
    NodeSelection top;
    for (std::uint32_t node = 0; node < 61; ++node)
        top.nodes.push_back(node);
    full.scene.fixed = {top};
    const Project fewer = withDetail(full, {Detail::Kind::Nodes, 150});
    EXPECT_THAT(validate(fewer), IsEmpty());
    EXPECT_EQ(fewer.mesh, full.mesh);
    EXPECT_EQ(fewer.base.mass, full.base.mass);
    EXPECT_EQ(evaluateModel(fewer).stiffening, full.base.stiffening);
    EXPECT_EQ(evaluateModel(withDetail(full, {Detail::Kind::Rigid})).stiffening, full.base.stiffening);
    EXPECT_EQ(evaluateModel(fewer).hinges.size(), fewer.network->springs.size());
    const Project rigid = withDetail(full, {Detail::Kind::Rigid});
    EXPECT_EQ(rigid.base.resistsBending, full.base.resistsBending);
    EXPECT_EQ(rigid.base.wallThickness, full.base.wallThickness);
    EXPECT_THAT(evaluateModel(rigid).hinges, IsEmpty());
    EXPECT_NEAR(fewer.scene.tethers[0].springConstant * 50, 2.4 * 581, 1e-9);
    const auto& at = fewer.network->restPositions;
    EXPECT_LT((at[fewer.scene.forces[0].node] - mesh.vertices[700]).norm(), 0.03);
    EXPECT_LE(fewer.scene.moves.size(), 2U);
    double lowest = 1;
    for (const std::uint32_t node : fewer.scene.fixed[0].nodes)
        lowest = std::min(lowest, at[node].z());
    EXPECT_GT(lowest, mesh.vertices[60].z() - 0.03);
    EXPECT_FALSE(fewer.scene.fixed[0].nodes.empty());

    const Project back = withDetail(fewer, {});
    EXPECT_THAT(validate(back), IsEmpty());
    EXPECT_EQ(back.network->restPositions, mesh.vertices);
    EXPECT_NEAR(back.scene.tethers[0].springConstant, 2.4, 1e-12);
    EXPECT_GE(back.scene.fixed[0].nodes.size(), 20U);
}

TEST(WithDetail, LeavesOutSplitsAndWhatActsOnTheNodesTheyMake) {
    Project full = organ(lumpySurface(30, 60), {});
    const auto made = static_cast<std::uint32_t>(full.network->restPositions.size());
    full.scene.splits = {{0.1, {{3, 4}, {4, 5}}}};
    full.scene.forces = {{700, {0, 0, 1}, 0, 1}, {made, {0, 0, 1}, 0, 1}};
    full.scene.moves = {{made, {{0, {0, 0, 0}}}}, {11, {{0, {0, 0, 1}}}}};
    full.scene.record.nodes = std::vector<std::uint32_t>{made, 700};
    const Project fewer = withDetail(full, {Detail::Kind::Nodes, 150});
    EXPECT_THAT(validate(fewer), IsEmpty());
    EXPECT_THAT(fewer.scene.splits, IsEmpty());
    EXPECT_EQ(fewer.scene.forces.size(), 1U);
    EXPECT_EQ(fewer.scene.moves.size(), 1U);
    EXPECT_EQ(fewer.scene.record.nodes->size(), 1U);
    EXPECT_THAT(withDetail(full, {Detail::Kind::Rigid}).scene.splits, IsEmpty());
}

TEST(WithDetail, GivesWhatBecomesRigidItsOwnHoldAndBack) {
    Project full = organ(body(), {});
    full.scene.forces = {{70, {0, 0, 1}, 0, 1}};
    const Project rigid = withDetail(full, {Detail::Kind::Rigid, 0});
    EXPECT_THAT(validate(rigid), IsEmpty());
    EXPECT_EQ(evaluateModel(rigid).fixedNodes.size(), 6U);
    const Project back = withDetail(rigid, {});
    EXPECT_THAT(validate(back), IsEmpty());
    EXPECT_THAT(evaluateModel(back).fixedNodes, IsEmpty());
    EXPECT_EQ(back.base.springConstant, full.base.springConstant);
    EXPECT_EQ(back.scene.tethers[0].springConstant, full.scene.tethers[0].springConstant);
}

TEST(DetailChange, KeepsFluidInThePartWhereItWas) {
    TriangleMesh mesh = test::ball(0.03, {0, 0, 0}, 20);
    test::append(mesh, test::ball(0.02, {0.1, 0, 0}, 8));
    Project project = makeProject("balls", {mesh, {}});
    for (const std::uint32_t part : {0U, 1U}) {
        project.scene.fillings = {{part, 1000}};
        for (const std::size_t nodes : {100U, 40U}) {
            const Project fewer = withDetail(project, {Detail::Kind::Nodes, nodes});
            const auto cavity = evaluateModel(fewer).cavities.at(0);
            const bool isSmall = fewer.network->restPositions[cavity.triangles[0][0]].x() > 0.05;
            EXPECT_EQ(isSmall, part == 1) << part << ", " << nodes;
        }
    }
}
