#include "core/texture/maps/finish_pages.h"

#include "core/support/parallel_steps.h"
#include "core/texture/maps/patch_frame.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace esm {

namespace {

constexpr float tiltSteps = 127;
constexpr int heightChannel = 2;
constexpr double noHeightSteps = 128, mostHeightSteps = 127;

/// In which patches the texels of a strip lie, and those of the row above it and the one below.
class PatchesAround {
public:
    /// @param patches of the triangles, see `TexelOwners`; outlive this
    PatchesAround(const std::vector<std::uint32_t>& patches, int size, int firstRow)
        : m_patches(patches), m_size(size), m_firstRow(firstRow - 1),
          m_owners(static_cast<std::size_t>(size) * (rowsPerStrip + 2), StripOwners::nobody) {}

    void add(const OwnedStrip& strip) {
        for (const TexelSpan& span : strip.spans)
            if (isHere(span.row))
                std::fill_n(&m_owners[index(span.first, span.row)], span.end - span.first,
                            m_patches[span.triangle]);
    }
    /// Whether a texel lies in the patch of a triangle.
    bool hasIn(std::uint32_t triangle, int x, int y) const {
        return x >= 0 && x < m_size && isHere(y) && m_owners[index(x, y)] == m_patches[triangle];
    }

private:
    bool isHere(int y) const { return y >= m_firstRow && y < m_firstRow + rowsPerStrip + 2; }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - m_firstRow) * static_cast<std::size_t>(m_size) +
               static_cast<std::size_t>(x);
    }

    const std::vector<std::uint32_t>& m_patches;
    int m_size, m_firstRow;
    std::vector<std::uint32_t> m_owners;
};

/// Which pages are read, and how tall their heights are.
struct Heights {
    const TriangleMesh& mesh;
    const Atlas& atlas;
    const TiledPages& pages;
    double metresPerStep; ///< of blue
};

double heightAt(const TiledImage& page, int x, int y) {
    return page.at(x, y)[heightChannel] - noHeightSteps;
}

/// Height gained per texel along one direction, in steps: over both neighbours, or the one that belongs to
/// the same patch. What belongs to another patch lies elsewhere on the surface.
double gained(const TiledImage& page, const PatchesAround& around, std::uint32_t triangle,
              std::array<int, 2> at, std::array<int, 2> step) {
    const auto [x, y] = at;
    const std::array<int, 2> back{x - step[0], y - step[1]}, forth{x + step[0], y + step[1]};
    const bool hasBack = around.hasIn(triangle, back[0], back[1]);
    const bool hasForth = around.hasIn(triangle, forth[0], forth[1]);
    const double from = hasBack ? heightAt(page, back[0], back[1]) : heightAt(page, x, y);
    const double to = hasForth ? heightAt(page, forth[0], forth[1]) : heightAt(page, x, y);
    return (to - from) / (hasBack && hasForth ? 2 : 1);
}

std::uint8_t tiltStep(double component) {
    return static_cast<std::uint8_t>(noTilt + std::lround(tiltSteps * component));
}

void paintTilts(const Heights& heights, const OwnedStrip& strip, const PatchesAround& around,
                TiledImage& page) {
    const TiledImage& from = heights.pages[static_cast<std::size_t>(strip.page)];
    TileRowPainter painter(page, strip.row);
    std::uint32_t framed = StripOwners::nobody;
    Eigen::Matrix2d slopesOf = Eigen::Matrix2d::Zero();
    for (const TexelSpan& span : strip.spans) {
        if (span.triangle != framed) {
            const auto frame = patchFrame(heights.mesh, heights.atlas, span.triangle);
            slopesOf = frame ? frame->slopesOf : Eigen::Matrix2d::Zero();
        }
        framed = span.triangle;
        for (int x = span.first; x < span.end;) {
            auto [pixel, count] = painter.run(x, span.end, span.row);
            for (; count > 0; --count, ++x, pixel += 4) {
                const std::array<int, 2> at{x, span.row};
                const Eigen::Vector2d perTexel(gained(from, around, span.triangle, at, {1, 0}),
                                               gained(from, around, span.triangle, at, {0, 1}));
                const Eigen::Vector2d slopes = slopesOf * perTexel * heights.metresPerStep;
                const Eigen::Vector2d tilt = -slopes / std::sqrt(1 + slopes.squaredNorm());
                std::copy_n(from.at(x, span.row), 2, pixel);
                pixel[2] = tiltStep(tilt.x());
                pixel[3] = tiltStep(tilt.y());
            }
        }
    }
}

using StripPlaces = std::map<std::pair<int, int>, const OwnedStrip*>; ///< by page and row

StripPlaces placesOf(const TexelOwners& owners) {
    StripPlaces places;
    for (const OwnedStrip& strip : owners.strips())
        places[{strip.page, strip.row}] = &strip;
    return places;
}

/// Whether the strip or one beside it differs from what it was.
bool hasChanged(const TiledImage& page, const TiledImage& before, int row) {
    for (int near = std::max(0, row - 1); near <= std::min(row + 1, page.rows() - 1); ++near)
        for (int column = 0; column < page.columns(); ++column)
            if (!page.sharesTile(before, column, near)) return true;
    return false;
}

bool areAlike(const TiledPages& a, const TiledPages& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const TiledImage& one, const TiledImage& other) { return one.isLike(other); });
}

TiledPages tiltedPages(const Heights& heights, const TexelOwners& owners, const FinishColour& base,
                       const FinishComposition& before, bool goesOn, const Progress& progress) {
    const int size = heights.atlas.options.size;
    TiledPages pages = goesOn
                           ? *before.pages
                           : TiledPages(heights.pages.size(),
                                        TiledImage(size, size, pageTile, {base[0], base[1], noTilt, noTilt}));
    const StripPlaces places = placesOf(owners);
    forEachInParallel(owners.strips().size(), progress, [&](std::size_t i) {
        const OwnedStrip& strip = owners.strips()[i];
        const auto page = static_cast<std::size_t>(strip.page);
        if (goesOn && !hasChanged(heights.pages[page], (*before.composed.pages)[page], strip.row)) return;
        PatchesAround around(owners.patches(), size, strip.row * rowsPerStrip);
        for (int row = strip.row - 1; row <= strip.row + 1; ++row)
            if (const auto found = places.find({strip.page, row}); found != places.end())
                around.add(*found->second);
        paintTilts(heights, strip, around, pages[page]);
    });
    return pages;
}

} // namespace

/// Heights are composed, and not normals: a height is the same whatever way a patch is turned, and mixes as
/// colours do where one photo fades into another. Normals follow from the heights of a texel's neighbours.
FinishComposition composedFinish(const TriangleMesh& mesh, const Atlas& atlas,
                                 const FinishComposition& before, const FinishLayers& layers,
                                 CompositionCache& cache, const Progress& progress) {
    ProgressParts parts(progress);
    FinishComposition made;
    made.greatestHeight = layers.greatestHeight;
    made.composed = {layers.layers, layers.base,
                     std::make_shared<const TiledPages>(recomposite(
                         mesh, atlas, before.composed, layers.layers, layers.base, cache, parts.next(0.7)))};
    const bool goesOn =
        before.pages && before.composed.pages && before.greatestHeight == made.greatestHeight &&
        before.composed.baseColour == layers.base && areAlike(*before.composed.pages, *made.composed.pages);
    const Heights heights{mesh, atlas, *made.composed.pages, made.greatestHeight / mostHeightSteps};
    const auto owners = cache.ownersOf(mesh, atlas, parts.next(0.1));
    made.pages = std::make_shared<const TiledPages>(
        tiltedPages(heights, *owners, layers.base, before, goesOn, parts.rest()));
    reportProgress(progress, 1);
    return made;
}

std::shared_ptr<const TiledPages> finishPages(const TriangleMesh& mesh, const Atlas& atlas,
                                              const std::vector<TextureLayer>& layers,
                                              const std::optional<SurfaceFinish>& base,
                                              const Progress& progress) {
    if (!hasFinish(layers, std::nullopt)) return nullptr;
    ProgressParts parts(progress);
    FinishPictures pictures;
    CompositionCache cache;
    const FinishLayers lending = finishLayers(layers, base, pictures, parts.next(0.2));
    return composedFinish(mesh, atlas, {}, lending, cache, parts.rest()).pages;
}

MaterialPage materialPage(const TiledImage& finish) {
    MaterialPage page{finish.image(), {}};
    Image normals{finish.width(), finish.height(),
                  std::vector<std::uint8_t>(page.wetnessAndRoughness.pixels.size())};
    bool isTilted = false;
    for (std::size_t i = 0; i < normals.pixels.size(); i += 4) {
        std::uint8_t* own = &page.wetnessAndRoughness.pixels[i];
        isTilted = isTilted || own[2] != noTilt || own[3] != noTilt;
        const Eigen::Vector2f tilt(static_cast<float>(own[2] - noTilt) / tiltSteps,
                                   static_cast<float>(own[3] - noTilt) / tiltSteps);
        const float upright = std::sqrt(std::max(0.0F, 1 - tilt.squaredNorm()));
        const std::array<std::uint8_t, 4> normal{own[2], own[3], tiltStep(upright), 255};
        std::copy(normal.begin(), normal.end(), &normals.pixels[i]);
        own[2] = 0;
        own[3] = 255;
    }
    if (isTilted) page.normals = std::move(normals);
    return page;
}

TiledImage finishPage(const MaterialPage& material) {
    Image page = material.wetnessAndRoughness;
    for (std::size_t i = 0; i < page.pixels.size(); i += 4) {
        page.pixels[i + 2] = material.normals.empty() ? noTilt : material.normals.pixels[i];
        page.pixels[i + 3] = material.normals.empty() ? noTilt : material.normals.pixels[i + 1];
    }
    return {page, pageTile};
}

} // namespace esm
