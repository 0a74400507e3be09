#include "core/project/detail_change.h"
#include "tests/support/cut_ball.h"
#include "tests/support/steady_progress.h"
#include "tests/support/test_meshes.h"
#include "tests/support/test_surfaces.h"

namespace esm {
namespace {

constexpr Detail fewNodes{Detail::Kind::Nodes, 300};

TEST(DetailProgress, OfMakingAProjectIsSteady) {
    const RepairedMesh surface{lumpySurface(60, 80), {}};
    test::expectGoodProgress(
        [&](const Progress& progress) { makeProject("organ", surface, std::nullopt, fewNodes, progress); });
}

TEST(DetailProgress, OfChangingTheDetailIsSteady) {
    Project project = makeProject("organ", {lumpySurface(60, 80), {}});
    NodeSelection fixed;
    for (std::uint32_t node = 0; node < 2000; ++node)
        fixed.nodes.push_back(node);
    project.scene.fixed = {fixed};
    for (const Detail& detail : {fewNodes, Detail{Detail::Kind::Rigid, 0}, Detail{}})
        test::expectGoodProgress([&](const Progress& progress) { withDetail(project, detail, progress); });
}

TEST(DetailProgress, OfRepairingIsSteady) {
    const PolygonSoup soup = test::soupOf(test::cutBall().mesh);
    test::expectGoodProgress([&](const Progress& progress) { repair(soup, {}, progress); });
    RepairOptions options;
    options.slitWidth = 1e-3;
    options.holeEdges = 200;
    test::expectGoodProgress([&](const Progress& progress) { repair(soup, options, progress); });
}

} // namespace
} // namespace esm
