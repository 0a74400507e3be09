#include "core/authoring/coarser_runs.h"

#include "core/project/detail_change.h"
#include "core/support/errors.h"
#include "tests/support/solid_surfaces.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

using namespace esm;

TEST(CoarserRuns, CanBeCancelled) {
    const Project project = makeProject("ball", {tissue::sphereMesh(3, 0.1), {}});
    EXPECT_THROW(coarserRuns(project, project.scene, [](double) { return false; }), Cancelled);
}

TEST(CoarserRuns, AreNoneOfWhatMovesRigidlyOrShowsNoVertex) {
    Project project = makeProject("ball", {tissue::sphereMesh(3, 0.1), {}});
    EXPECT_EQ(coarserRuns(project, project.scene).size(), 1U);
    SpringNetwork inside = *project.network;
    inside.restPositions.emplace_back(0, 0, 0);
    project.network = std::make_shared<const SpringNetwork>(inside);
    EXPECT_TRUE(coarserRuns(project, project.scene).empty());
    const Project rigid =
        makeProject("ball", {tissue::sphereMesh(3, 0.1), {}}, 0.5, {Detail::Kind::Rigid, 0});
    EXPECT_TRUE(coarserRuns(rigid, rigid.scene).empty());
}

/// A hollow organ is another one, even where what is recorded are the corners of both.
TEST(CoarserRuns, AreNoneOfWhatIsFilled) {
    Project solid = makeProject("block", {test::block({0, 0, 0}, {0.06, 0.04, 0.04}), {}}, 0.5,
                                {Detail::Kind::Filled, 0, LatticeFilling{LatticeKind::Cubic, 0.01}});
    std::vector<std::uint32_t> corners;
    for (std::uint32_t node = 0; node < solid.network->restPositions.size(); ++node)
        for (const Eigen::Vector3d& corner : solid.mesh->vertices)
            if (solid.network->restPositions[node] == corner) corners.push_back(node);
    ASSERT_FALSE(corners.empty());
    solid.scene.record.nodes = corners;
    EXPECT_TRUE(coarserRuns(solid, solid.scene).empty());
}

TEST(WithRun, RecommendsItOnItsNodes) {
    const Project project = makeProject("ball", {tissue::sphereMesh(3, 0.1), {}});
    TradeoffRun run;
    run.stepping = {Integrator::Split, 0.02, Precision::Double};
    run.error = 0.03;
    run.wallPerSimulatedSecond = 0.004;
    const Project same = withRun(project, run);
    EXPECT_EQ(same.network, project.network);
    ASSERT_TRUE(same.stepping);
    EXPECT_EQ(same.stepping->stepping.integrator, Integrator::Split);
    EXPECT_EQ(same.stepping->stepping.timeStep, 0.02);
    EXPECT_EQ(same.stepping->error, 0.03);
    EXPECT_EQ(same.stepping->wallPerSimulatedSecond, 0.004);

    run.coarser = Detail{Detail::Kind::Nodes, 160};
    const Project fewer = withRun(same, run);
    EXPECT_EQ(fewer.network->restPositions.size(), 160U);
    EXPECT_TRUE(fewer.stepping);
    EXPECT_FALSE(withDetail(same, {Detail::Kind::Nodes, 160}).stepping);
}
