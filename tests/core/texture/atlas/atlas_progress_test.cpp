#include "core/support/errors.h"
#include "core/texture/atlas/atlas.h"
#include "tests/support/steady_progress.h"
#include "tests/support/test_surfaces.h"

namespace esm {
namespace {

TEST(AtlasProgress, OfPackingIsSteadyInEveryLayout) {
    const TriangleMesh mesh = lumpySurface(40, 60);
    for (const AtlasLayout layout : atlasLayouts) {
        test::expectGoodProgress([&](const Progress& progress) {
            packAtlas(mesh, {512, 1, 2, layout}, progress);
        });
        const double scale = packAtlas(mesh, {512, 1, 2, layout}).texelsPerMetre;
        test::expectGoodProgress([&](const Progress& progress) {
            packAtlas(mesh, {256, 1, 2, layout, scale}, progress);
        });
    }
}

TEST(AtlasProgress, OfPackingIsSteadyUpToARefusal) {
    const TriangleMesh mesh = lumpySurface(40, 60);
    for (const AtlasLayout layout : atlasLayouts) {
        double last = 0;
        EXPECT_THROW(packAtlas(mesh, {32, 1, 8, layout},
                               [&](double fraction) {
                                   EXPECT_GE(fraction, last);
                                   last = fraction;
                                   return true;
                               }),
                     InvalidModel);
        EXPECT_GT(last, 0.5);
    }
}

} // namespace
} // namespace esm
