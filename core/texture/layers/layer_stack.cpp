#include "core/texture/layers/layer_stack.h"

#include "core/texture/layers/multi_band.h"
#include "core/texture/layers/surface_beneath.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Texels around a patch whose colours are asked for, in which a stroke may begin.
constexpr double strokeMargin = 3;

bool looksElsewhere(const TextureLayer& layer) {
    return std::any_of(layer.strokes.begin(), layer.strokes.end(),
                       [](const auto& stroke) { return copies(stroke->kind); });
}

bool needsQuery(const TextureLayer& layer) {
    return (layer.photo && layer.projector.occlusion) || looksElsewhere(layer) ||
           layer.blending == Blending::MultiBand;
}

std::shared_ptr<PreparedLayer> preparedLayer(const TextureLayer& layer, const LitSurface& surface,
                                             CompositionCache& cache, const Progress& progress) {
    auto made = std::make_shared<PreparedLayer>();
    made->layer = layer;
    if (layer.photo) {
        ProgressParts parts(progress);
        made->projected = cache.sampled(pictureOf(layer));
        const std::shared_ptr<const Image>& picture = made->projected.picture;
        if (layer.projector.occlusion)
            made->lighting =
                cache.lightingOf({layer.projector, sizeOf(*picture)}, surface.mesh, parts.next(0.7));
        made->fade = cache.fadeOf({layer.projector, picture, layer.blendPixels, fadesAtMask(layer)},
                                  surface.mesh, parts.rest());
    }
    for (const auto& stroke : layer.strokes)
        made->strokeReach.push_back(reachOf(*stroke));
    return made;
}

constexpr std::array<std::uint8_t, 3> black{0, 0, 0}, white{255, 255, 255};

/// Where a photo that is blended in bands has faded by half at an outline, what it shows ends for the bands:
/// colours on either side have nothing to do with each other.
void eraseOutlines(Image& mask, PhotoSize photo, const PhotoFade& outlines) {
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) {
            const double column = (x + 0.5) * photo.width / mask.width;
            if (outlines.weightAt(column, (y + 0.5) * photo.height / mask.height) < 0.5)
                std::fill_n(mask.at(x, y), 3, std::uint8_t{0});
        }
}

Image whitePicture(PhotoSize size) {
    const auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    return {size.width, size.height, std::vector<std::uint8_t>(4 * pixels, 255)};
}

/// Metres of the surface in one texel of the patch; 0 for a patch without extent.
double metresPerTexel(const Eigen::Matrix3d& corners, const Patch& patch) {
    const double metres = (corners.col(1) - corners.col(0)).norm() + (corners.col(2) - corners.col(0)).norm();
    const double texels = (patch[1] - patch[0]).norm() + (patch[2] - patch[0]).norm();
    return texels > 0 ? metres / texels : 0;
}

} // namespace

/// As a layer of paint it is seen in the photo's plane by what sees layers there already.
TextureLayer paintedMask(const BrushStrokes& strokes) {
    TextureLayer mask;
    for (const auto& stroke : strokes) {
        BrushStroke painted = *stroke;
        painted.kind = BrushKind::Colour;
        painted.colour = stroke->kind == BrushKind::Erase ? black : white;
        mask.strokes.push_back(std::make_shared<const BrushStroke>(std::move(painted)));
    }
    return mask;
}

/// From the lowest up, since a photo that is blended in bands needs all beneath it finished: `shown` and the
/// stack so far are what it is blended into. Its own border fades over four pixels at most, because the bands
/// have made its colours agree with what lies beneath there.
LayerStack::LayerStack(const TriangleMesh& mesh, const std::vector<Patch>& patches,
                       const std::vector<TextureLayer>& layers, std::array<std::uint8_t, 3> baseColour,
                       CompositionCache& cache, const Progress& progress)
    : m_surface{mesh, nullptr, hidingTolerance(mesh), nullptr}, m_patches(patches),
      m_baseColour(baseColour[0], baseColour[1], baseColour[2]) {
    ProgressParts parts(progress);
    std::vector<TextureLayer> shown;
    for (const TextureLayer& layer : layers) {
        ProgressParts steps(parts.next(1.0 / static_cast<double>(layers.size())));
        if (!isShown(layer)) continue;
        if (!m_query && needsQuery(layer)) m_query = cache.queryOf(mesh);
        m_surface.query = m_query.get();
        m_normals = cache.normalsOf(mesh);
        m_surface.normals = m_normals.get();
        auto made = preparedLayer(layer, m_surface, cache, steps.next(0.5));
        if (layer.blending == Blending::MultiBand) {
            auto blended = cache.banded(layer, shown, baseColour);
            if (!blended) {
                blended = blendedInBands(*made, cache, steps.rest());
                cache.keep({layer, shown, baseColour, *blended});
            }
            made->projected = std::move(*blended);
            made->layer.blendPixels = std::min(layer.blendPixels, bandedBorder);
        }
        made->rims = rimsOf(layer.strokes, shown, baseColour, cache);
        if (layer.photo)
            made->photo.emplace(LayerPhoto{made->layer, *made->projected.sampler,
                                           photoMatrix(layer.projector, sizeOf(*made->projected.picture)),
                                           made->fade.get()});
        m_layers.push_back(std::move(made));
        shown.push_back(layer);
    }
}

LayerStack::LayerStack(const LayerStack& stack, const std::vector<Patch>& patches)
    : m_surface(stack.m_surface), m_patches(patches), m_baseColour(stack.m_baseColour),
      m_query(stack.m_query), m_normals(stack.m_normals), m_layers(stack.m_layers) {}

/// In the photo's plane and not in the texture: there neighbours are not neighbours on the surface, and no
/// pyramid could be built. What lies beneath, and the mask that was painted on the organ, are seen from the
/// projector as pictures of that plane.
SampledPicture LayerStack::blendedInBands(const PreparedLayer& made, CompositionCache& cache,
                                          const Progress& progress) const {
    ProgressParts parts(progress);
    const Image& picture = *made.projected.picture;
    const PhotoSize photo = sizeOf(picture);
    const PhotoPlane plane{made.layer.projector, photo, comparedSize(photo)};
    const std::vector<Patch> patches = patchesIn(plane, m_surface.mesh);
    const Image beneath = surfaceBeneath(LayerStack(*this, patches), *m_query, plane, parts.next(0.5));
    Image mask;
    if (!made.layer.strokes.empty())
        mask = surfaceBeneath(
            LayerStack(m_surface.mesh, patches, {paintedMask(made.layer.strokes)}, white, cache), *m_query,
            plane, parts.next(0.3));
    if (made.fade) {
        if (mask.empty()) mask = whitePicture(plane.picture);
        eraseOutlines(mask, photo, *made.fade);
    }
    const auto blended = std::make_shared<const Image>(esm::blendedInBands(
        picture, *made.projected.sampler, beneath, mask, made.layer.blendPixels, parts.rest()));
    return {blended, std::make_shared<const PhotoSampler>(*blended)};
}

Eigen::Vector3f
/// A clone takes what the layers beneath have at the nearest point of the surface, computed there anew. So
/// composing stays a function of the layers alone: read from the page it would depend on what was painted
/// first. A clone may find a clone there: `follows` ends what would else go on without end, or grow with each
/// level.
LayerStack::colourNear(const Eigen::Vector3d& point, std::size_t layers, int follows,
                       std::unordered_map<std::uint32_t, std::unique_ptr<TriangleLayers>>& known) const {
    const std::optional<RayHit> hit = m_query->nearest(point);
    if (!hit) return m_baseColour;
    auto& source = known[hit->triangle];
    if (!source) source = std::make_unique<TriangleLayers>(*this, hit->triangle, layers, follows);
    return source->colour({0, 0, 0, hit->barycentric, hit->barycentric});
}

LayerColour LayerOnTriangle::at(const PatchTexel& texel) const {
    if (!m_projection) return painted(pointAt(texel.extended));
    LayerColour own = m_projection->at(texel);
    if (own.weight > 0 && !m_strokes.empty()) own.weight *= mask(pointAt(texel.extended));
    return own;
}

SurfacePoint LayerOnTriangle::pointAt(const Eigen::Vector3d& weights) const {
    return {m_corners * weights, (m_normals * weights).normalized()};
}

/// Each stroke takes the mask towards 0 or 1 by its weight, in the order in which they were painted: the
/// order matters where they cross.
float LayerOnTriangle::mask(const SurfacePoint& point) const {
    float mask = 1;
    for (const StrokeOnTriangle& stroke : m_strokes) {
        const auto weight = static_cast<float>(stroke.weightAt(point));
        const float target = stroke.stroke().kind == BrushKind::Erase ? 0 : 1;
        mask += weight * (target - mask);
    }
    return mask;
}

/// Strokes over one another as half-transparent paints: the new cover is that of either (a + b − ab), and the
/// colour moves towards the new one by the part that the new paint has in the cover, weight / cover. That
/// keeps the colour itself unmixed with the nothing beneath the layer, so that a soft edge of red is red and
/// not dark. Erasing is kept apart in the mask, so that restoring brings the paint back.
LayerColour LayerOnTriangle::painted(const SurfacePoint& point) const {
    Eigen::Vector3f colour = Eigen::Vector3f::Zero();
    float cover = 0, mask = 1;
    for (std::size_t i = 0; i < m_strokes.size(); ++i) {
        const StrokeOnTriangle& stroke = m_strokes[i];
        const auto weight = static_cast<float>(stroke.weightAt(point));
        if (!(weight > 0)) continue;
        const float target = stroke.stroke().kind == BrushKind::Erase ? 0 : 1;
        mask += weight * (target - mask);
        if (!laysColour(stroke.stroke().kind)) continue;
        const float together = cover + weight * (1 - cover);
        colour += weight / together * (colourOf(i, point.place) - colour);
        cover = together;
    }
    return {colour.homogeneous(), cover * mask * static_cast<float>(m_prepared->layer.opacity)};
}

Eigen::Vector3f LayerOnTriangle::colourOf(std::size_t place, const Eigen::Vector3d& point) const {
    const BrushStroke& stroke = m_strokes[place].stroke();
    if (!copies(stroke.kind))
        return {static_cast<float>(stroke.colour[0]), static_cast<float>(stroke.colour[1]),
                static_cast<float>(stroke.colour[2])};
    Eigen::Vector3f copied = m_stack->colourNear(point + stroke.shift, m_place, m_follows - 1, m_sources);
    const HealingRim* rim = m_rims[place];
    if (!rim) return copied;
    return (copied + rim->at(point)).cwiseMax(0).cwiseMin(255);
}

TriangleLayers::TriangleLayers(const LayerStack& stack, std::uint32_t triangle, std::size_t layers,
                               int follows)
    : m_stack(&stack) {
    for (std::size_t place = 0; place < layers; ++place)
        if (auto layer = reaching(place, triangle, follows)) m_layers.push_back(std::move(*layer));
}

/// Whether a layer can reach the triangle at all, from the cheapest question to the dearest. Most layers drop
/// out here, and texels ask only the others.
std::optional<LayerOnTriangle> TriangleLayers::reaching(std::size_t place, std::uint32_t triangle,
                                                        int follows) const {
    const LitSurface& surface = m_stack->m_surface;
    const Patch& patch = m_stack->m_patches[triangle];
    LayerOnTriangle on;
    on.m_stack = m_stack;
    on.m_prepared = m_stack->m_layers[place].get();
    on.m_place = place;
    on.m_follows = follows;
    const TextureLayer& layer = on.m_prepared->layer;
    if (layer.photo) {
        const PreparedLayer& prepared = *on.m_prepared;
        const Lighting lighting =
            prepared.lighting ? prepared.lighting->triangles[triangle] : Lighting::Unknown;
        if (lighting == Lighting::Hidden) return std::nullopt;
        const SeenSide side = prepared.lighting ? prepared.lighting->sides[triangle] : SeenSide::Both;
        const auto projection = TriangleProjection::make(*prepared.photo, surface,
                                                         {triangle, side, lighting == Lighting::Lit}, patch);
        if (!projection) return std::nullopt;
        on.m_projection.emplace(*projection);
    }
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t vertex = surface.mesh.triangles[triangle][i];
        on.m_corners.col(static_cast<Eigen::Index>(i)) = surface.mesh.vertices[vertex];
        on.m_normals.col(static_cast<Eigen::Index>(i)) = (*surface.normals)[vertex];
        box.extend(surface.mesh.vertices[vertex]);
    }
    const double margin = strokeMargin * metresPerTexel(on.m_corners, patch);
    const Eigen::Vector3d around = Eigen::Vector3d::Constant(margin);
    const Eigen::AlignedBox3d asked(box.min() - around, box.max() + around);
    bool laysColour = false;
    for (std::size_t i = 0; i < layer.strokes.size(); ++i) {
        const BrushStroke& stroke = *layer.strokes[i];
        if (!on.m_prepared->strokeReach[i].intersects(asked)) continue;
        if (copies(stroke.kind) && follows == 0) continue;
        auto met = StrokeOnTriangle::make(stroke, {on.m_corners, on.m_normals}, margin);
        if (!met) continue;
        laysColour = laysColour || esm::laysColour(stroke.kind);
        on.m_strokes.push_back(std::move(*met));
        on.m_rims.push_back(on.m_prepared->rims[i].get());
    }
    if (!layer.photo && !laysColour) return std::nullopt;
    return on;
}

/// Laying a layer of colour c and weight w over what lies beneath gives w·c + (1 − w)·beneath; multiplying
/// gives beneath · (1 − w + w·c/255), a screen w·c + beneath · (1 − w·c/255). All are linear in what lies
/// beneath, so the sum can be taken from the topmost down: `passing` is the factor that the rest still has.
/// An opaque layer ends it, and what it hides is never read. Of eight photos on an organ that halves the work
/// (docs/performance.md). What an overlay or a colour makes of the rest is not linear in it: there the rest
/// is finished first.
Eigen::Vector3f TriangleLayers::colourOfLowest(std::size_t layers, const PatchTexel& texel) const {
    Eigen::Array4f colour = Eigen::Array4f::Zero();
    Eigen::Array4f passing = Eigen::Array4f::Ones(); // the share that what lies beneath has in each channel
    for (std::size_t place = layers; place-- > 0;) {
        const LayerColour laid = m_layers[place].at(texel);
        const Eigen::Array4f own = laid.colour;
        const float weight = laid.weight;
        if (!(weight > 0)) continue;
        const Blending blending = m_layers[place].blending();
        if (blending == Blending::Multiply) {
            passing *= 1 - weight + weight / 255 * own;
            continue;
        }
        if (!isLinear(blending)) {
            const Eigen::Array3f beneath = colourOfLowest(place, texel);
            const Eigen::Array3f mixed = 255 * blended(blending, beneath / 255, own.head<3>() / 255);
            return colour.head<3>() + passing.head<3>() * (beneath + weight * (mixed - beneath));
        }
        colour += weight * passing * own;
        if (blending == Blending::Screen) {
            passing *= 1 - weight / 255 * own;
            continue;
        }
        if (weight >= 1) return colour.head<3>();
        passing *= 1 - weight;
    }
    return colour.head<3>() + passing.head<3>() * m_stack->m_baseColour.array();
}

} // namespace esm
