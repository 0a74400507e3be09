#include "core/project/project.h"

#include "core/dynamics/simulation.h"
#include "tests/support/cut_ball.h"
#include "tests/support/test_meshes.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

/// A vertex nearest to a point.
std::uint32_t nodeAt(const SpringNetwork& network, const Eigen::Vector3d& point) {
    std::uint32_t nearest = 0;
    for (std::uint32_t i = 0; i < network.restPositions.size(); ++i)
        if ((network.restPositions[i] - point).norm() < (network.restPositions[nearest] - point).norm())
            nearest = i;
    return nearest;
}

/// How far the slit's sides are apart at the most, m, when its upper side is pulled outwards in the middle.
double widestWhenPulled(const test::CutMesh& cut, double slitWidth) {
    RepairOptions options;
    options.slitWidth = slitWidth;
    const Project project = makeProject("ball", repair(test::soupOf(cut.mesh), options));
    const SpringNetwork& network = *project.network;
    std::vector<Edge> across;
    for (std::size_t i = 0; i < cut.upper.size(); ++i)
        across.emplace_back(nodeAt(network, cut.mesh.vertices[cut.upper[i]]),
                            nodeAt(network, cut.mesh.vertices[cut.lower[i]]));
    Simulation simulation(evaluateModel(project), {});
    const std::uint32_t pulled = across[across.size() / 2].first;
    Loads loads;
    loads.forces = {{pulled, 2 * network.restPositions[pulled].normalized() + Eigen::Vector3d(0, 1, 0)}};
    const auto steps = static_cast<std::size_t>(0.5 / simulation.timeStep());
    EXPECT_EQ(simulation.advance(loads, steps), steps) << simulation.failure();
    double widest = 0;
    for (const auto& [upper, lower] : across)
        widest = std::max(widest, (simulation.positions()[upper] - simulation.positions()[lower]).norm());
    EXPECT_GT((simulation.positions()[pulled] - network.restPositions[pulled]).norm(), 2e-3);
    return widest;
}

TEST(ProjectMended, DoesNotTearWhereASlitWasClosed) {
    const test::CutMesh cut = test::cutBall();
    EXPECT_GT(widestWhenPulled(cut, 0), 5e-3); // what mending is for
    EXPECT_EQ(widestWhenPulled(cut, 6e-4), 0); // both sides are one line of nodes
}

} // namespace
} // namespace esm
