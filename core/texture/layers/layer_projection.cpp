#include "core/texture/layers/layer_projection.h"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>

namespace esm {

namespace {

/// How the weights of a triangle's corners change over its patch; 0 for a patch without area.
Eigen::Matrix<double, 3, 2> weightsPerTexel(const std::array<Eigen::Vector2d, 3>& patch) {
    Eigen::Matrix2d texels;
    texels << patch[1] - patch[0], patch[2] - patch[0];
    Eigen::Matrix<double, 3, 2> weights;
    weights.bottomRows<2>() = texels.inverse();
    weights.row(0) = -weights.row(1) - weights.row(2);
    if (!weights.allFinite()) weights.setZero();
    return weights;
}

/// Photo pixels per texel along the direction in which they are densest, at a place (x·w, y·w, w).
double pixelsPerTexel(const Eigen::Vector3d& place, const Eigen::Matrix<double, 3, 2>& placePerTexel) {
    const Eigen::Matrix2d perTexel =
        (placePerTexel.topRows<2>() - place.head<2>() / place.z() * placePerTexel.row(2)) / place.z();
    const double half = perTexel.squaredNorm() / 2, product = perTexel.determinant();
    const double density = std::sqrt(half + std::sqrt(std::max(0.0, half * half - product * product)));
    return std::isfinite(density) ? density : 0;
}

} // namespace

std::optional<TriangleProjection>
TriangleProjection::make(const TextureLayer& layer, const PhotoSampler& sampler, const LitSurface& surface,
                         const LitTriangle& triangle, const std::array<Eigen::Vector2d, 3>& patch) {
    TriangleProjection projection(layer, sampler, surface);
    for (Eigen::Index i = 0; i < 3; ++i)
        projection.m_corners.col(i) =
            surface.mesh.vertices[surface.mesh.triangles[triangle.triangle][static_cast<std::size_t>(i)]];
    const PhotoSize size{sampler.width(), sampler.height()};
    projection.m_places = photoMatrix(layer.projector, size) * projection.m_corners.colwise().homogeneous();
    projection.m_placePerTexel = projection.m_places.topRows<3>() * weightsPerTexel(patch);
    if (!projection.mayTakeColour()) return std::nullopt;
    projection.m_isLit = triangle.isLit;
    if (layer.projector.kind == ProjectorKind::Parallel)
        projection.m_depth = projection.pyramidDepth(projection.m_places.col(0).head<3>());
    return projection;
}

bool TriangleProjection::mayTakeColour() const {
    const bool isParallel = m_layer.projector.kind == ProjectorKind::Parallel;
    const Eigen::Vector3d normal =
        (m_corners.col(1) - m_corners.col(0)).cross(m_corners.col(2) - m_corners.col(0));
    // An eye may stand inside an organ and see its wall from there: then only rays tell what it sees.
    if (isParallel && m_layer.projector.occlusion &&
        !(normal.dot(m_layer.projector.pose.linear().col(2)) > 0))
        return false;
    if (m_places.row(3).maxCoeff() < (isParallel ? -m_surface.tolerance : 0)) return false;
    if (!(m_places.row(2).minCoeff() > 0)) return true; // reaches behind the eye: corners bound nothing
    const Eigen::Matrix<double, 2, 3> pixels =
        m_places.topRows<2>().array().rowwise() / m_places.row(2).array();
    double density = 0;
    for (Eigen::Index i = 0; i < 3; ++i)
        density = std::max(density, pixelsPerTexel(m_places.col(i).head<3>(), m_placePerTexel));
    const double margin = 3 * density; // texels around the patch read a little beyond it
    const Eigen::Vector2d low = pixels.rowwise().minCoeff(), high = pixels.rowwise().maxCoeff();
    return !(high.x() < -margin || high.y() < -margin || low.x() > m_sampler.width() + margin ||
             low.y() > m_sampler.height() + margin);
}

Eigen::Vector4f TriangleProjection::at(const PatchTexel& texel) const {
    const Eigen::Vector4d seen = m_places * texel.extended;
    if (!seen.allFinite() || !(seen.z() > 0) || seen.w() < -m_surface.tolerance)
        return Eigen::Vector4f::Zero();
    const Eigen::Vector2d pixel = seen.head<2>() / seen.z();
    const double border = borderWeight(pixel);
    if (!(border > 0)) return Eigen::Vector4f::Zero();
    const bool isParallel = m_layer.projector.kind == ProjectorKind::Parallel;
    Eigen::Vector4f colour =
        m_sampler.at(pixel.x(), pixel.y(), isParallel ? m_depth : pyramidDepth(seen.head<3>()));
    colour.w() *= static_cast<float>(border * m_layer.opacity);
    if (colour.w() > 0) colour.w() *= static_cast<float>(lightWeight(texel.nearest));
    return colour;
}

double TriangleProjection::pyramidDepth(const Eigen::Vector3d& place) const {
    const double density = pixelsPerTexel(place, m_placePerTexel);
    return density > 1 ? std::log2(density) : 0; // a patch without area shows the photo itself
}

double TriangleProjection::borderWeight(const Eigen::Vector2d& pixel) const {
    if (!pixel.allFinite()) return 0;
    const double inside =
        std::min({pixel.x(), pixel.y(), m_sampler.width() - pixel.x(), m_sampler.height() - pixel.y()});
    if (inside < 0) return 0;
    return m_layer.blendPixels > 0 ? std::min(1.0, inside / m_layer.blendPixels) : 1;
}

double TriangleProjection::lightWeight(const Eigen::Vector3d& nearest) const {
    double weight = 1;
    if (m_layer.projector.falloff) {
        const Eigen::Vector3d normal =
            (m_corners.col(1) - m_corners.col(0)).cross(m_corners.col(2) - m_corners.col(0));
        weight = angleWeight(normal.normalized().dot(towardsLight(m_corners * nearest)));
    }
    return weight > 0 && m_layer.projector.occlusion && !m_isLit && isHidden(nearest) ? 0 : weight;
}

Eigen::Vector3d TriangleProjection::towardsLight(const Eigen::Vector3d& point) const {
    const Eigen::Isometry3d& pose = m_layer.projector.pose;
    if (m_layer.projector.kind == ProjectorKind::Parallel) return pose.linear().col(2);
    return (pose.translation() - point).normalized();
}

bool TriangleProjection::isHidden(const Eigen::Vector3d& nearest) const {
    const Eigen::Vector3d point = m_corners * nearest, way = towardsLight(point);
    const double distance = m_layer.projector.kind == ProjectorKind::Parallel
                                ? m_places.row(3).dot(nearest)
                                : way.dot(m_layer.projector.pose.translation() - point);
    return distance > 2 * m_surface.tolerance &&
           m_surface.query->isBlocked(point, point + distance * way, m_surface.tolerance);
}

} // namespace esm
