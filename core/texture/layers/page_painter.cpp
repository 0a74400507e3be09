#include "core/texture/layers/page_painter.h"

#include "core/texture/layers/patch_scan.h"

#include <algorithm>
#include <tbb/parallel_for.h>

namespace esm {

namespace {

/// Bands between two reports of progress.
constexpr std::size_t bandsPerReport = 16;

void paintBand(const LayerStack& stack, const Atlas& atlas, const PageBand& band, const TriangleMarks& only,
               Image& page) {
    const double reach = fillReach(atlas.options);
    const BandOwners owners(atlas, band, reach);
    for (const std::uint32_t triangle : band.triangles) {
        if (!only.empty() && !only[triangle]) continue;
        const TriangleLayers layers(stack, triangle);
        if (only.empty() && layers.layers().empty()) continue; // the page has the base colour
        PatchScan(atlas.corners[triangle])
            .forEachTexel(band, page.width, reach, [&](const PatchTexel& texel) {
                if (owners.at(texel.x, texel.y) != triangle) return;
                const Eigen::Vector3f colour = layers.colour(texel);
                std::uint8_t* pixel = page.at(texel.x, texel.y);
                for (int channel = 0; channel < 3; ++channel)
                    pixel[channel] =
                        static_cast<std::uint8_t>(std::clamp(colour[channel] + 0.5F, 0.0F, 255.0F));
            });
    }
}

bool isMeant(const PageBand& band, const TriangleMarks& only) {
    return only.empty() || std::any_of(band.triangles.begin(), band.triangles.end(),
                                       [&](std::uint32_t triangle) { return only[triangle] != 0; });
}

} // namespace

void paintPages(const LayerStack& stack, const Atlas& atlas, const TriangleMarks& only,
                std::vector<Image>& pages, const Progress& progress) {
    std::vector<PageBand> bands = pageBands(atlas);
    bands.erase(std::remove_if(bands.begin(), bands.end(),
                               [&](const PageBand& band) { return !isMeant(band, only); }),
                bands.end());
    for (std::size_t first = 0; first < bands.size(); first += bandsPerReport) {
        reportProgress(progress, static_cast<double>(first) / static_cast<double>(bands.size()));
        tbb::parallel_for(first, std::min(first + bandsPerReport, bands.size()), [&](std::size_t i) {
            paintBand(stack, atlas, bands[i], only, pages[static_cast<std::size_t>(bands[i].page)]);
        });
    }
    reportProgress(progress, 1);
}

} // namespace esm
