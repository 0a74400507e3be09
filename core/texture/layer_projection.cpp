#include "core/texture/layer_projection.h"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>

namespace esm {

namespace {

bool facesProjector(const Eigen::Matrix3d& corners, const Projector& projector) {
    const Eigen::Vector3d normal = (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
    return normal.dot(projector.pose.linear().col(2)) > 0;
}

/// Photo pixels per texel along the direction in which they are densest.
double pixelsPerTexel(const Eigen::Matrix3d& places, const std::array<Eigen::Vector2d, 3>& patch) {
    Eigen::Matrix2d texels, pixels;
    texels << patch[1] - patch[0], patch[2] - patch[0];
    pixels << (places.col(1) - places.col(0)).head<2>(), (places.col(2) - places.col(0)).head<2>();
    const Eigen::Matrix2d perTexel = pixels * texels.inverse();
    const double half = perTexel.squaredNorm() / 2, product = perTexel.determinant();
    const double density = std::sqrt(half + std::sqrt(std::max(0.0, half * half - product * product)));
    return std::isfinite(density) ? density : 0; // a patch without area shows the photo itself
}

} // namespace

std::optional<TriangleProjection> TriangleProjection::make(const PhotoLayer& layer,
                                                           const PhotoSampler& sampler,
                                                           const LitSurface& surface, std::uint32_t triangle,
                                                           const std::array<Eigen::Vector2d, 3>& patch) {
    TriangleProjection projection(layer, sampler, surface);
    for (Eigen::Index i = 0; i < 3; ++i) {
        const std::uint32_t vertex = surface.mesh.triangles[triangle][static_cast<std::size_t>(i)];
        projection.m_corners.col(i) = surface.mesh.vertices[vertex];
        const Eigen::Vector3d place = project(layer.projector, surface.mesh.vertices[vertex]);
        projection.m_places.col(i) =
            place.cwiseProduct(Eigen::Vector3d(sampler.width(), sampler.height(), 1));
    }
    if (layer.projector.occlusion && !facesProjector(projection.m_corners, layer.projector))
        return std::nullopt;
    const double density = pixelsPerTexel(projection.m_places, patch);
    projection.m_depth = density > 1 ? std::log2(density) : 0;
    const double margin = 3 * density; // texels around the patch read a little beyond it
    const Eigen::Vector3d low = projection.m_places.rowwise().minCoeff(),
                          high = projection.m_places.rowwise().maxCoeff();
    if (high.x() < -margin || high.y() < -margin || low.x() > sampler.width() + margin ||
        low.y() > sampler.height() + margin || high.z() < -surface.tolerance)
        return std::nullopt;
    return projection;
}

Eigen::Vector4f TriangleProjection::at(const PatchTexel& texel) const {
    const Eigen::Vector3d place = m_places * texel.extended;
    if (!place.allFinite()) return Eigen::Vector4f::Zero();
    const double border = borderWeight(place);
    if (border <= 0 || place.z() < -m_surface.tolerance) return Eigen::Vector4f::Zero();
    Eigen::Vector4f colour = m_sampler.at(place.x(), place.y(), m_depth);
    colour.w() *= static_cast<float>(border * m_layer.opacity);
    if (colour.w() > 0 && m_layer.projector.occlusion && isHidden(texel.nearest)) colour.w() = 0;
    return colour;
}

double TriangleProjection::borderWeight(const Eigen::Vector3d& place) const {
    const double inside =
        std::min({place.x(), place.y(), m_sampler.width() - place.x(), m_sampler.height() - place.y()});
    if (inside < 0) return 0;
    return m_layer.blendPixels > 0 ? std::min(1.0, inside / m_layer.blendPixels) : 1;
}

bool TriangleProjection::isHidden(const Eigen::Vector3d& nearest) const {
    const Eigen::Vector3d point = m_corners * nearest;
    const double depth = m_places.row(2).dot(nearest);
    const Eigen::Vector3d source = point + depth * m_layer.projector.pose.linear().col(2);
    return depth > 2 * m_surface.tolerance && m_surface.query->isBlocked(point, source, m_surface.tolerance);
}

} // namespace esm
