#include "core/texture/layers/covering_layer.h"

#include "core/texture/layers/brush_stroke.h"
#include "core/texture/projection/projector.h"

#include <algorithm>

namespace esm {

namespace {

/// Of a layer's weight, from which on what lies beneath cannot be told.
constexpr double hidingWeight = 0.98;

/// Of the way to the projector, at both ends, that need not be free: the surface lies there itself.
constexpr double freeShare = 0.001;

Eigen::Vector3d lightOf(const Projector& projector, const Eigen::Vector3d& point, double depth) {
    if (projector.isParallel()) return point + depth * projector.pose.linear().col(2);
    return projector.pose.translation();
}

/// The share of a projector's light that the surface takes there.
double lightShare(const Projector& projector, const SurfacePoint& point, double depth,
                  const SurfaceQuery& surface) {
    const Eigen::Vector3d light = lightOf(projector, point.place, depth), way = light - point.place;
    const double cosine = way.normalized().dot(point.normal);
    if (projector.occlusion && (cosine <= 0 || surface.isBlocked(point.place, light, freeShare * way.norm())))
        return 0;
    return projector.falloff ? angleWeight(cosine) : 1;
}

/// 1 inside of the photo, falling to 0 over the blending width at its border.
double borderShare(const Eigen::Vector2d& pixel, const Image& photo, double blendPixels) {
    const double nearest =
        std::min({pixel.x(), pixel.y(), photo.width - pixel.x(), photo.height - pixel.y()});
    if (nearest < 0) return 0;
    return blendPixels > 0 ? std::min(1.0, nearest / blendPixels) : 1;
}

/// The share of a layer's photo at a point, 0 to 1, but for how it fades towards outlines and its mask: that
/// is no reason to say that nothing hides what is painted.
double photoShare(const TextureLayer& layer, const SurfacePoint& point, const SurfaceQuery& surface) {
    const Image& picture = *pictureOf(layer);
    const auto place = project(layer.projector, sizeOf(picture), point.place);
    if (!place || place->z() <= 0) return 0;
    const double border = borderShare(place->head<2>(), picture, layer.blendPixels);
    if (border <= 0) return 0;
    const int x = std::min(static_cast<int>(place->x()), picture.width - 1);
    const int y = std::min(static_cast<int>(place->y()), picture.height - 1);
    return border * picture.at(x, y)[3] / 255.0 * lightShare(layer.projector, point, place->z(), surface);
}

double strokeShare(const BrushStroke& stroke, const SurfacePoint& point) {
    const TriangleCorners corners{point.place.replicate<1, 3>(), point.normal.replicate<1, 3>()};
    const auto reaching = StrokeOnTriangle::make(stroke, corners, 0);
    return reaching ? reaching->weightAt(point) : 0;
}

/// Erasing is a mask over what the layer has there, so that restoring brings back no more than that.
double shareAt(const TextureLayer& layer, const SurfacePoint& point, const SurfaceQuery& surface) {
    double cover = layer.photo ? photoShare(layer, point, surface) : 0, mask = 1;
    for (const auto& stroke : layer.strokes) {
        const double weight = strokeShare(*stroke, point);
        mask += weight * ((stroke->kind == BrushKind::Erase ? 0 : 1) - mask);
        if (laysColour(stroke->kind)) cover += weight * (1 - cover);
    }
    return cover * mask;
}

} // namespace

const TextureLayer* coveringLayer(const std::vector<TextureLayer>& layers, LayerId layer,
                                  const SurfacePoint& point, const SurfaceQuery& surface) {
    const auto place = placeOf(layers, layer);
    if (!place) return nullptr;
    for (std::size_t i = *place + 1; i < layers.size(); ++i) {
        const TextureLayer& above = layers[i];
        const bool mayHide = isShown(above) && hides(above.blending);
        if (mayHide && above.opacity * shareAt(above, point, surface) >= hidingWeight) return &above;
    }
    return nullptr;
}

} // namespace esm
