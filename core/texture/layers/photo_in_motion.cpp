#include "core/texture/layers/photo_in_motion.h"

#include "core/support/parallel_steps.h"
#include "core/texture/layers/layer_stack.h"
#include "core/texture/layers/multi_band.h"
#include "core/texture/layers/page_painter.h"
#include "core/texture/layers/plane_rays.h"

#include <algorithm>
#include <array>

namespace esm {

namespace {

constexpr std::array<std::uint8_t, 3> allIsLeft{255, 255, 255};

/// Bands are made of differences that pass slowly; followed by this many rays they take a few hundredths of a
/// second.
constexpr int longestSideInMotion = 128;

PhotoSize sizeInMotion(PhotoSize photo) {
    while (std::max(photo.width, photo.height) > longestSideInMotion)
        photo = {(photo.width + 1) / 2, (photo.height + 1) / 2};
    return photo;
}

/// Metres of the surface in a pixel of the plane's picture, so far from the projector (m).
double pixelWidth(const PhotoPlane& plane, double distance) {
    if (plane.projector.isParallel()) return plane.projector.width / plane.picture.width;
    const double perPixel = static_cast<double>(plane.photo.width) / plane.picture.width;
    return distance * perPixel / intrinsicsOf(plane.projector, plane.photo).fx;
}

const std::uint8_t* texelAt(const LaidTexture& texture, std::uint32_t triangle,
                            const Eigen::Vector3d& weights) {
    const TiledImage& page = texture.pages[texture.atlas.page[triangle]];
    const auto& corners = texture.atlas.corners[triangle];
    const Eigen::Vector2d place = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
    return page.at(std::clamp(static_cast<int>(place.x()), 0, page.width() - 1),
                   std::clamp(static_cast<int>(place.y()), 0, page.height() - 1));
}

/// The mean of four texels, as far apart as a pixel is wide or, on small triangles, over half of one: never
/// of another triangle, which may lie anywhere in the page.
void takeTexels(const LaidTexture& texture, const RayHit& hit, double width, std::uint8_t* pixel) {
    const Triangle& corners = texture.mesh.triangles[hit.triangle];
    const std::vector<Eigen::Vector3d>& vertices = texture.mesh.vertices;
    const double side = (vertices[corners[1]] - vertices[corners[0]]).norm();
    const double share = side > 0 ? std::min(0.5, width / side) : 0;
    std::array<int, 4> sum{};
    for (Eigen::Index corner = -1; corner < 3; ++corner) {
        Eigen::Vector3d weights = hit.barycentric;
        if (corner >= 0) weights += share * (Eigen::Vector3d::Unit(corner) - weights);
        const std::uint8_t* texel = texelAt(texture, hit.triangle, weights);
        for (std::size_t channel = 0; channel < 4; ++channel)
            sum[channel] += texel[channel];
    }
    std::transform(sum.begin(), sum.end(), pixel,
                   [](int value) { return static_cast<std::uint8_t>((value + 2) / 4); });
}

/// What the texture shows in a photo's plane.
struct SeenTexture {
    Image colours; ///< alpha 0 where there is nothing
    Image mask;    ///< black where strokes have erased the photo
};

/// As it was composed when the photo began to move: to ask the layers anew at each place of the projector
/// takes ten times as long.
SeenTexture seenTexture(const LaidTexture& texture, const PhotoPlane& plane, CompositionCache& cache,
                        const Progress& progress) {
    const auto [width, height] = plane.picture;
    const auto bytes = 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    SeenTexture seen{{width, height, std::vector<std::uint8_t>(bytes)},
                     {width, height, std::vector<std::uint8_t>(bytes, 255)}};
    const auto query = cache.queryOf(texture.mesh);
    const std::vector<SeenSide> sides = cache.sidesOf(plane.projector, texture.mesh);
    const PlaneRays rays(texture.mesh, *query, plane, sides);
    forEachInParallel(static_cast<std::size_t>(plane.picture.height), progress, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < plane.picture.width; ++x) {
            const auto hit = rays.hit(x, y);
            if (!hit) continue;
            std::uint8_t* pixel = seen.colours.at(x, y);
            takeTexels(texture, *hit, pixelWidth(plane, hit->distance), pixel);
            std::fill_n(seen.mask.at(x, y), 3, pixel[3]);
            pixel[3] = 255;
        }
    });
    return seen;
}

} // namespace

double borderInMotion(const TextureLayer& layer) {
    const bool isBanded = layer.blending == Blending::MultiBand;
    return isBanded ? std::min(layer.blendPixels, bandedBorder) : layer.blendPixels;
}

TiledPages maskedPages(const TriangleMesh& mesh, const Atlas& atlas, const TiledPages& pages,
                       const BrushStrokes& strokes, CompositionCache& cache, const Progress& progress) {
    ProgressParts parts(progress);
    const LayerStack mask(mesh, atlas.corners, {paintedMask(strokes)}, allIsLeft, cache, parts.next(0.1));
    TiledPages masked = pages;
    const auto owners = cache.ownersOf(mesh, atlas, parts.next(0.4));
    paintAlpha(mask, atlas, *owners, masked, parts.rest());
    return masked;
}

Image bandsInMotion(const LaidTexture& texture, const TextureLayer& layer, CompositionCache& cache,
                    const Progress& progress) {
    const SampledPicture picture = cache.sampled(pictureOf(layer));
    const PhotoSize photo = sizeOf(*picture.picture);
    const PhotoPlane plane{layer.projector, photo, sizeInMotion(photo)};
    const SeenTexture seen = seenTexture(texture, plane, cache, progress);
    return bandsAddedTo(*picture.sampler, seen.colours, layer.strokes.empty() ? Image() : seen.mask,
                        layer.blendPixels);
}

} // namespace esm
