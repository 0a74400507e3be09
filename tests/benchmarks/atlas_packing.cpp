#include "tests/benchmarks/atlas_packing.h"

#include "core/texture/atlas/atlas.h"
#include "tests/support/test_surfaces.h"

#include <memory>

namespace benchmarks {

namespace {

constexpr int packingRepetitions = 3;

std::string nameOf(esm::AtlasLayout layout, const std::string& triangles) {
    return std::string("packing ") + esm::wordOf(layout) + ", " + triangles;
}

} // namespace

std::vector<Ratio> registerAtlasPacking() {
    std::vector<Ratio> ratios;
    for (const auto& [triangles, rings] : {std::pair{"20 k", 100}, std::pair{"200 k", 320}}) {
        for (const esm::AtlasLayout layout : esm::atlasLayouts) {
            registerWork(nameOf(layout, triangles), packingRepetitions, [layout, rings = rings] {
                const auto mesh = std::make_shared<esm::TriangleMesh>(lumpySurface(rings, rings));
                return [mesh, layout] { benchmark::DoNotOptimize(packAtlas(*mesh, {4096, 1, 2, layout})); };
            });
        }
        const std::string rows = nameOf(esm::AtlasLayout::Rows, triangles);
        for (const esm::AtlasLayout layout :
             {esm::AtlasLayout::MatchedRows, esm::AtlasLayout::UnfoldedGroups})
            ratios.push_back({nameOf(layout, triangles) + ": to the source's rows", nameOf(layout, triangles),
                              rows, Clock::Wall, 0, 5});
    }
    return ratios;
}

} // namespace benchmarks
