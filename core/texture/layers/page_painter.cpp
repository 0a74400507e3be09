#include "core/texture/layers/page_painter.h"

#include "core/support/parallel_steps.h"
#include "core/texture/layers/patch_scan.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace esm {

namespace {

/// @param value 0 to 255
template<typename Channel> Channel stored(float value) {
    constexpr float largest = std::numeric_limits<Channel>::max();
    return static_cast<Channel>(std::clamp(value * (largest / 255) + 0.5F, 0.0F, largest));
}

/// A page in one piece, as TileRowPainter has one in tiles.
template<typename Channel> class WholePainter {
public:
    explicit WholePainter(ImageOf<Channel>& page) : m_page(page) {}

    struct Run {
        Channel* pixels;
        int count;
    };
    Run run(int x, int end, int y) { return {m_page.at(x, y), end - x}; }

private:
    ImageOf<Channel>& m_page;
};

/// Red, green and blue; alpha stays.
struct PutColour {
    template<typename Channel> void operator()(Channel* pixel, const Eigen::Vector3f& colour) const {
        for (int channel = 0; channel < 3; ++channel)
            pixel[channel] = stored<Channel>(colour[channel]);
    }
};

struct PutAlpha {
    void operator()(std::uint8_t* pixel, const Eigen::Vector3f& colour) const {
        pixel[3] = stored<std::uint8_t>(colour.x());
    }
};

template<typename Painter, typename Put>
void paintSpan(const TriangleLayers& layers, const PatchScan& patch, const TexelSpan& span, Painter& painter,
               const Put& put) {
    for (int x = span.first; x < span.end;) {
        auto [pixel, count] = painter.run(x, span.end, span.row);
        for (; count > 0; --count, ++x, pixel += 4)
            put(pixel, layers.colour(patch.texel(x, span.row)));
    }
}

/// Spans come by triangles: the layers that reach one are chosen once for all its texels in the strip.
template<typename Painter, typename Put = PutColour>
void paintStrip(const LayerStack& stack, const Atlas& atlas, const OwnedStrip& strip,
                const TriangleMarks& only, SharedProgress& progress, Painter painter, const Put& put = {}) {
    const auto end = strip.spans.end();
    for (auto first = strip.spans.begin(), next = first; first != end; first = next) {
        const std::uint32_t triangle = first->triangle;
        next = std::find_if(first, end, [&](const TexelSpan& span) { return span.triangle != triangle; });
        progress.add(static_cast<std::size_t>(next - first));
        if (!only.empty() && !only[triangle]) continue;
        const TriangleLayers layers(stack, triangle);
        if (only.empty() && layers.layers().empty()) continue; // the page has the base colour
        const PatchScan patch(atlas.corners[triangle]);
        for (auto span = first; span != next; ++span)
            paintSpan(layers, patch, *span, painter, put);
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
        paintStrip(stack, atlas, strips[i], only, spans,
                   WholePainter<Channel>(pages[static_cast<std::size_t>(strips[i].page)]));
    });
    reportProgress(progress, 1);
}

void paintPages(const LayerStack& stack, const Atlas& atlas, const TexelOwners& owners,
                const TriangleMarks& only, TiledPages& pages, const Progress& progress) {
    const std::vector<OwnedStrip>& strips = owners.strips();
    SharedProgress spans(progress, spansIn(strips));
    forEachInParallel(strips.size(), {}, [&](std::size_t i) {
        paintStrip(stack, atlas, strips[i], only, spans,
                   TileRowPainter(pages[static_cast<std::size_t>(strips[i].page)], strips[i].row));
    });
    reportProgress(progress, 1);
}

void paintAlpha(const LayerStack& stack, const Atlas& atlas, const TexelOwners& owners, TiledPages& pages,
                const Progress& progress) {
    const std::vector<OwnedStrip>& strips = owners.strips();
    SharedProgress spans(progress, spansIn(strips));
    forEachInParallel(strips.size(), {}, [&](std::size_t i) {
        TileRowPainter painter(pages[static_cast<std::size_t>(strips[i].page)], strips[i].row);
        paintStrip(stack, atlas, strips[i], {}, spans, std::move(painter), PutAlpha());
    });
    reportProgress(progress, 1);
}

template void paintPages(const LayerStack&, const Atlas&, const TexelOwners&, const TriangleMarks&,
                         std::vector<Image>&, const Progress&);
template void paintPages(const LayerStack&, const Atlas&, const TexelOwners&, const TriangleMarks&,
                         std::vector<DeepImage>&, const Progress&);

} // namespace esm
