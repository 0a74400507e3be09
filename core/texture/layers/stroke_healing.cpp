#include "core/support/parallel_steps.h"
#include "core/texture/layers/layer_stack.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace esm {

namespace {

constexpr std::size_t placesPerBlock = 16;

/// Every triangle flat in a picture of so many pixels per metre: a photo beneath is then read as a mean over
/// pixels of that size, whatever texture is composed.
std::vector<Patch> flatPatches(const TriangleMesh& mesh, double pixelsPerMetre) {
    std::vector<Patch> patches;
    patches.reserve(mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles) {
        const Eigen::Vector3d first =
            pixelsPerMetre * (mesh.vertices[triangle[1]] - mesh.vertices[triangle[0]]);
        const Eigen::Vector3d second =
            pixelsPerMetre * (mesh.vertices[triangle[2]] - mesh.vertices[triangle[0]]);
        const double length = first.norm();
        const double along = length > 0 ? second.dot(first) / length : 0;
        const double across = std::sqrt(std::max(0.0, second.squaredNorm() - along * along));
        patches.push_back(
            Patch{Eigen::Vector2d(0, 0), Eigen::Vector2d(length, 0), Eigen::Vector2d(along, across)});
    }
    return patches;
}

/// The surface's point that a place beside a stroke lies at; nothing where there is none on the brush's side,
/// or the surface ends before.
std::optional<Eigen::Vector3d> surfaceAt(const BrushPoint& place, const StrokeOutline& outline,
                                         const LitSurface& surface) {
    const auto hit = surface.query->nearest(place.place);
    if (!hit) return std::nullopt;
    const Triangle& triangle = surface.mesh.triangles[hit->triangle];
    if (areaNormal(surface.mesh.vertices, triangle).dot(place.normal) <= 0) return std::nullopt;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i)
        point += hit->barycentric[static_cast<Eigen::Index>(i)] * surface.mesh.vertices[triangle[i]];
    return outline.isOutside(point) ? std::optional(point) : std::nullopt;
}

} // namespace

/// Each place around the stroke is asked for its colour and for that of what would be copied there, by the
/// layers beneath. Colours are means over a sixth of the radius: single details on either side say nothing of
/// the shade.
HealingRim LayerStack::rimOf(const BrushStroke& stroke) const {
    constexpr double pixelsPerRadius = 6;
    const std::vector<Patch> patches = flatPatches(m_surface.mesh, pixelsPerRadius / stroke.radius);
    const LayerStack beneath(*this, patches);
    const StrokeOutline outline(stroke);
    const std::vector<BrushPoint> around = outline.placesAround();
    std::vector<std::optional<HealingRim::Place>> found(around.size());
    const std::size_t blocks = (around.size() + placesPerBlock - 1) / placesPerBlock;
    forEachInParallel(blocks, {}, [&](std::size_t block) {
        std::unordered_map<std::uint32_t, std::unique_ptr<TriangleLayers>> known;
        const auto colourAt = [&](const Eigen::Vector3d& point) {
            return beneath.colourNear(point, m_layers.size(), TriangleLayers::deepestClone - 1, known);
        };
        const std::size_t end = std::min((block + 1) * placesPerBlock, around.size());
        for (std::size_t i = block * placesPerBlock; i < end; ++i)
            if (const auto point = surfaceAt(around[i], outline, m_surface))
                found[i] = HealingRim::Place{*point, colourAt(*point) - colourAt(*point + stroke.shift)};
    });
    std::vector<HealingRim::Place> places;
    for (const auto& place : found)
        if (place) places.push_back(*place);
    return {places, outline.spacing()};
}

std::vector<std::shared_ptr<const HealingRim>> LayerStack::rimsOf(const BrushStrokes& strokes,
                                                                  const std::vector<TextureLayer>& beneath,
                                                                  std::array<std::uint8_t, 3> baseColour,
                                                                  CompositionCache& cache) const {
    std::vector<std::shared_ptr<const HealingRim>> rims(strokes.size());
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        if (strokes[i]->kind != BrushKind::Heal) continue;
        rims[i] = cache.healed(*strokes[i], beneath, baseColour);
        if (rims[i]) continue;
        rims[i] = std::make_shared<const HealingRim>(rimOf(*strokes[i]));
        cache.keep(HealedStroke{strokes[i], beneath, baseColour, rims[i]});
    }
    return rims;
}

} // namespace esm
