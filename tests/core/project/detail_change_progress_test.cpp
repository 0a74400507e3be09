#include "core/project/detail_change.h"
#include "tests/support/steady_progress.h"
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

} // namespace
} // namespace esm
