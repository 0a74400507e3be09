#include "core/texture/layers/page_painter.h"

#include "core/texture/layers/patch_scan.h"
#include "core/texture/parallel_steps.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace esm {

namespace {

/// @param value 0 to 255
template<typename Channel> Channel stored(float value) {
    constexpr float largest = std::numeric_limits<Channel>::max();
    return static_cast<Channel>(std::clamp(value * (largest / 255) + 0.5F, 0.0F, largest));
}

/// Spans come by triangles: the layers that reach one are chosen once for all its texels in the strip.
template<typename Channel>
void paintStrip(const LayerStack& stack, const Atlas& atlas, const OwnedStrip& strip,
                const TriangleMarks& only, SharedProgress& progress, ImageOf<Channel>& page) {
    const auto end = strip.spans.end();
    for (auto first = strip.spans.begin(), next = first; first != end; first = next) {
        const std::uint32_t triangle = first->triangle;
        next = std::find_if(first, end, [&](const TexelSpan& span) { return span.triangle != triangle; });
        progress.add(static_cast<std::size_t>(next - first));
        if (!only.empty() && !only[triangle]) continue;
        const TriangleLayers layers(stack, triangle);
        if (only.empty() && layers.layers().empty()) continue; // the page has the base colour
        const PatchScan patch(atlas.corners[triangle]);
        for (auto span = first; span != next; ++span) {
            Channel* pixel = page.at(span->first, span->row);
            for (int x = span->first; x < span->end; ++x, pixel += 4) {
                const Eigen::Vector3f colour = layers.colour(patch.texel(x, span->row));
                for (int channel = 0; channel < 3; ++channel)
                    pixel[channel] = stored<Channel>(colour[channel]);
            }
        }
    }
}

std::size_t spansIn(const std::vector<OwnedStrip>& strips) {
    return std::accumulate(strips.begin(), strips.end(), std::size_t{0},
                           [](std::size_t sum, const OwnedStrip& strip) { return sum + strip.spans.size(); });
}

} // namespace

template<typename Channel>
void paintPages(const LayerStack& stack, const Atlas& atlas, const TexelOwners& owners,
                const TriangleMarks& only, std::vector<ImageOf<Channel>>& pages, const Progress& progress) {
    const std::vector<OwnedStrip>& strips = owners.strips();
    SharedProgress spans(progress, spansIn(strips));
    forEachInParallel(strips.size(), {}, [&](std::size_t i) {
        paintStrip(stack, atlas, strips[i], only, spans, pages[static_cast<std::size_t>(strips[i].page)]);
    });
    reportProgress(progress, 1);
}

template void paintPages(const LayerStack&, const Atlas&, const TexelOwners&, const TriangleMarks&,
                         std::vector<Image>&, const Progress&);
template void paintPages(const LayerStack&, const Atlas&, const TexelOwners&, const TriangleMarks&,
                         std::vector<DeepImage>&, const Progress&);

} // namespace esm
