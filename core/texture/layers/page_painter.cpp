#include "core/texture/layers/page_painter.h"

#include "core/texture/layers/patch_scan.h"

#include <algorithm>
#include <limits>
#include <tbb/parallel_for.h>

namespace esm {

namespace {

/// Bands between two reports of progress.
constexpr std::size_t bandsPerReport = 16;

/// @param value 0 to 255
template<typename Channel> Channel stored(float value) {
    constexpr float largest = std::numeric_limits<Channel>::max();
    return static_cast<Channel>(std::clamp(value * (largest / 255) + 0.5F, 0.0F, largest));
}

template<typename Channel>
void paintBand(const LayerStack& stack, const Atlas& atlas, const PageBand& band, const TriangleMarks& only,
               ImageOf<Channel>& page) {
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
                Channel* pixel = page.at(texel.x, texel.y);
                for (int channel = 0; channel < 3; ++channel)
                    pixel[channel] = stored<Channel>(colour[channel]);
            });
    }
}

bool isMeant(const PageBand& band, const TriangleMarks& only) {
    return only.empty() || std::any_of(band.triangles.begin(), band.triangles.end(),
                                       [&](std::uint32_t triangle) { return only[triangle] != 0; });
}

} // namespace

template<typename Channel>
void paintPages(const LayerStack& stack, const Atlas& atlas, const TriangleMarks& only,
                std::vector<ImageOf<Channel>>& pages, const Progress& progress) {
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

template void paintPages(const LayerStack&, const Atlas&, const TriangleMarks&, std::vector<Image>&,
                         const Progress&);
template void paintPages(const LayerStack&, const Atlas&, const TriangleMarks&, std::vector<DeepImage>&,
                         const Progress&);

} // namespace esm
