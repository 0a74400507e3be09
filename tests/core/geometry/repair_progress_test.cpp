#include "core/geometry/repair.h"
#include "tests/support/cut_ball.h"
#include "tests/support/steady_progress.h"
#include "tests/support/test_meshes.h"

namespace esm {
namespace {

TEST(RepairProgress, IsSteady) {
    const PolygonSoup soup = test::soupOf(test::cutBall().mesh);
    test::expectGoodProgress([&](const Progress& progress) { repair(soup, {}, progress); });
    RepairOptions options;
    options.slitWidth = 1e-3;
    options.holeEdges = 200;
    test::expectGoodProgress([&](const Progress& progress) { repair(soup, options, progress); });
}

} // namespace
} // namespace esm
