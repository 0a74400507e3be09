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

/// Levels of the pyramid by which a patch's corners may differ for the depth to be taken as linear over it:
/// an eighth of a level changes the size of what is averaged by 9 %. It spares a logarithm in every texel of
/// a small patch.
constexpr double nearlyLinear = 0.125;

/// Photo pixels per texel along the direction in which they are densest, at a place (x·w, y·w, w). The
/// derivative of (x·w, y·w) / w over the patch is the 2 × 2 matrix J = (∂(xw, yw) − (x, y) ∂w) / w. Its
/// larger singular value is the density: with half = (σ₁² + σ₂²) / 2 = |J|² / 2 and product = σ₁ σ₂ = |det J|
/// it is σ₁² = half + √(half² − product²). The larger and not the mean, since what is read too fine flickers
/// and what is read too coarse is only soft [R 4.3.2.4].
double pixelsPerTexel(const Eigen::Vector3d& place, const Eigen::Matrix<double, 3, 2>& placePerTexel) {
    const Eigen::Matrix2d perTexel =
        (placePerTexel.topRows<2>() - place.head<2>() / place.z() * placePerTexel.row(2)) / place.z();
    const double half = perTexel.squaredNorm() / 2, product = perTexel.determinant();
    const double density = std::sqrt(half + std::sqrt(std::max(0.0, half * half - product * product)));
    return std::isfinite(density) ? density : 0;
}

/// In the pyramid; a patch without area shows the photo itself.
double pyramidDepth(double pixelsPerTexel) {
    return pixelsPerTexel > 1 ? std::log2(pixelsPerTexel) : 0;
}

} // namespace

/// All that can be told of the triangle as a whole is told here, once, so that a texel costs a matrix
/// product, a reading of the photo and at worst a ray. Projective coordinates (x·w, y·w, w) are linear over
/// the triangle, unlike x and y: mixing those of the corners and dividing in the texel is exact in
/// perspective.
std::optional<TriangleProjection> TriangleProjection::make(const LayerPhoto& photo, const LitSurface& surface,
                                                           const LitTriangle& triangle,
                                                           const std::array<Eigen::Vector2d, 3>& patch) {
    TriangleProjection projection(photo, surface);
    for (Eigen::Index i = 0; i < 3; ++i)
        projection.m_corners.col(i) =
            surface.mesh.vertices[surface.mesh.triangles[triangle.triangle][static_cast<std::size_t>(i)]];
    if (!projection.facesParallelLight()) return std::nullopt;
    projection.m_places = photo.matrix * projection.m_corners.colwise().homogeneous();
    if (!projection.m_places.allFinite()) return std::nullopt;
    projection.m_placePerTexel = projection.m_places.topRows<3>() * weightsPerTexel(patch);
    Eigen::Vector3d densities;
    for (Eigen::Index i = 0; i < 3; ++i)
        densities[i] = pixelsPerTexel(projection.m_places.col(i).head<3>(), projection.m_placePerTexel);
    if (!projection.mayTakeColour(densities)) return std::nullopt;
    projection.m_isLit = triangle.isLit;
    projection.m_normal = projection.areaNormal().normalized();
    if (photo.layer.projector.falloff && projection.isParallel())
        projection.m_parallelFalloff =
            angleWeight(projection.m_normal.dot(photo.layer.projector.pose.linear().col(2)));
    projection.m_depths = densities.unaryExpr(&pyramidDepth);
    projection.m_isDepthLinear =
        projection.m_places.row(2).minCoeff() > 0 &&
        projection.m_depths.maxCoeff() - projection.m_depths.minCoeff() < nearlyLinear;
    return projection;
}

Eigen::Vector3d TriangleProjection::areaNormal() const {
    return (m_corners.col(1) - m_corners.col(0)).cross(m_corners.col(2) - m_corners.col(0));
}

bool TriangleProjection::facesParallelLight() const {
    // An eye may stand inside an organ and see its wall from there: then only rays tell what it sees.
    if (!isParallel() || !m_layer.projector.occlusion) return true;
    return areaNormal().dot(m_layer.projector.pose.linear().col(2)) > 0;
}

bool TriangleProjection::mayTakeColour(const Eigen::Vector3d& densities) const {
    if (m_places.row(3).maxCoeff() < (isParallel() ? -m_surface.tolerance : 0)) return false;
    if (!(m_places.row(2).minCoeff() > 0)) return true; // reaches behind the eye: corners bound nothing
    const Eigen::Matrix<double, 2, 3> pixels =
        m_places.topRows<2>().array().rowwise() / m_places.row(2).array();
    const double margin = 3 * densities.maxCoeff(); // texels around the patch read a little beyond it
    const Eigen::Vector2d low = pixels.rowwise().minCoeff(), high = pixels.rowwise().maxCoeff();
    return !(high.x() < -margin || high.y() < -margin || low.x() > m_sampler.width() + margin ||
             low.y() > m_sampler.height() + margin);
}

/// In the order of the price: a product, the border, a reading of the photo, and a ray only where all others
/// leave some weight. The place is that of the texel itself, beyond the patch's side as well, so that a
/// filter finds the photo going on there. Whether light comes is asked at the nearest point of the patch:
/// beyond its side the triangle's plane may lie inside the organ, where all hides it.
LayerColour TriangleProjection::at(const PatchTexel& texel) const {
    const Eigen::Vector4d seen = m_places * texel.extended;
    if (!(seen.z() > 0) || seen.w() < -m_surface.tolerance) return {Eigen::Vector4f::Zero(), 0};
    const double x = seen.x() / seen.z(), y = seen.y() / seen.z();
    const double border = borderWeight(x, y);
    if (!(border > 0)) return {Eigen::Vector4f::Zero(), 0};
    const Eigen::Vector4f colour = m_sampler.at(x, y, depthAt(seen, texel.extended));
    float weight = colour.w() * static_cast<float>(border * m_layer.opacity);
    if (weight > 0) weight *= static_cast<float>(lightWeight(texel.nearest));
    return {colour, weight};
}

double TriangleProjection::depthAt(const Eigen::Vector4d& seen, const Eigen::Vector3d& weights) const {
    return m_isDepthLinear ? m_depths.dot(weights)
                           : pyramidDepth(pixelsPerTexel(seen.head<3>(), m_placePerTexel));
}

/// [R 4.3.3]: rises linearly over the distance to the nearest side of the photo.
double TriangleProjection::borderWeight(double x, double y) const {
    const double inside = std::min(std::min(x, y), std::min(m_sampler.width() - x, m_sampler.height() - y));
    if (!(inside >= 0)) return 0; // nor for a place that is not finite
    return m_layer.blendPixels > 0 ? std::min(1.0, inside / m_layer.blendPixels) : 1;
}

double TriangleProjection::lightWeight(const Eigen::Vector3d& nearest) const {
    const double weight = m_layer.projector.falloff ? falloffAt(nearest) : 1;
    return weight > 0 && m_layer.projector.occlusion && !m_isLit && isHidden(nearest) ? 0 : weight;
}

double TriangleProjection::falloffAt(const Eigen::Vector3d& nearest) const {
    return isParallel() ? m_parallelFalloff : angleWeight(m_normal.dot(towardsLight(m_corners * nearest)));
}

Eigen::Vector3d TriangleProjection::towardsLight(const Eigen::Vector3d& point) const {
    const Eigen::Isometry3d& pose = m_layer.projector.pose;
    if (isParallel()) return pose.linear().col(2);
    return (pose.translation() - point).normalized();
}

/// A shadow ray from the point towards the light. Both ends are kept off the surface by the tolerance, else
/// rounding would let the triangle hide itself, as speckles; a point within two tolerances of the light has
/// no room for anything between.
bool TriangleProjection::isHidden(const Eigen::Vector3d& nearest) const {
    const Eigen::Vector3d point = m_corners * nearest, way = towardsLight(point);
    const double distance =
        isParallel() ? m_places.row(3).dot(nearest) : way.dot(m_layer.projector.pose.translation() - point);
    return distance > 2 * m_surface.tolerance &&
           m_surface.query->isBlocked(point, point + distance * way, m_surface.tolerance);
}

} // namespace esm
