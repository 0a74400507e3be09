#include "core/texture/layers/layer_projection.h"

#include "core/support/smooth_step.h"
#include "core/texture/layers/lit_triangles.h"

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

/// What is read of the photo, pixels, by texels in a patch and a little around it. Precondition: all corners
/// lie before the eye.
Eigen::AlignedBox2d boxInPhoto(const Eigen::Matrix<double, 4, 3>& places, const Eigen::Vector3d& densities) {
    const Eigen::Matrix<double, 2, 3> pixels = places.topRows<2>().array().rowwise() / places.row(2).array();
    const double margin = 3 * densities.maxCoeff();
    return {pixels.rowwise().minCoeff().array() - margin, pixels.rowwise().maxCoeff().array() + margin};
}

/// Of the angle from which on surface loses a photo with a border even without falloff, 80°: at an outline it
/// would end along the edges of triangles.
constexpr double grazingCosine = 0.17365;

} // namespace

/// All that can be told of the triangle as a whole is told here, once, so that a texel costs a matrix
/// product, a reading of the photo and at worst a ray. Projective coordinates (x·w, y·w, w) are linear over
/// the triangle, unlike x and y: mixing those of the corners and dividing in the texel is exact in
/// perspective.
std::optional<TriangleProjection> TriangleProjection::make(const LayerPhoto& photo, const LitSurface& surface,
                                                           const LitTriangle& triangle,
                                                           const std::array<Eigen::Vector2d, 3>& patch) {
    TriangleProjection projection(photo, surface, triangle);
    if (projection.isTurnedAway()) return std::nullopt;
    projection.m_places = photo.matrix * projection.m_corners.colwise().homogeneous();
    if (!projection.m_places.allFinite()) return std::nullopt;
    projection.m_placePerTexel = projection.m_places.topRows<3>() * weightsPerTexel(patch);
    Eigen::Vector3d densities;
    for (Eigen::Index i = 0; i < 3; ++i)
        densities[i] = pixelsPerTexel(projection.m_places.col(i).head<3>(), projection.m_placePerTexel);
    if (!projection.mayTakeColour(densities)) return std::nullopt;
    projection.m_depths = densities.unaryExpr(&pyramidDepth);
    projection.m_isDepthLinear =
        projection.m_places.row(2).minCoeff() > 0 &&
        projection.m_depths.maxCoeff() - projection.m_depths.minCoeff() < nearlyLinear;
    projection.m_facesLight = projection.facesLight();
    projection.findClearPart(densities);
    return projection;
}

TriangleProjection::TriangleProjection(const LayerPhoto& photo, const LitSurface& surface,
                                       const LitTriangle& triangle)
    : m_photo(photo), m_layer(photo.layer), m_sampler(photo.sampler), m_surface(surface),
      m_side(triangle.side), m_isLit(triangle.isLit) {
    const Triangle& corners = surface.mesh.triangles[triangle.triangle];
    for (Eigen::Index i = 0; i < 3; ++i) {
        const std::uint32_t vertex = corners[static_cast<std::size_t>(i)];
        m_corners.col(i) = surface.mesh.vertices[vertex];
        m_normals.col(i) = (*surface.normals)[vertex];
    }
}

/// Where all corners turn away, so does every normal between them. A photo without a border ends right at the
/// edge beyond which a triangle itself turns away. What takes colour on both sides turns neither away, not
/// even where it is seen edge-on.
bool TriangleProjection::isTurnedAway() const {
    if (m_side == SeenSide::Both) return false;
    const Eigen::Vector3d outward =
        (m_corners.col(1) - m_corners.col(0)).cross(m_corners.col(2) - m_corners.col(0));
    const double cosine = outward.normalized().dot(towardsLight(m_corners.col(0)));
    if (!(m_layer.blendPixels > 0) && !(cosineSeen(m_side, cosine) > 0)) return true;
    for (Eigen::Index i = 0; i < 3; ++i)
        if (cosineSeen(m_side, m_normals.col(i).dot(towardsLight(m_corners.col(i)))) > 0) return false;
    return true;
}

/// Normals and ways to the light between the corners' are mixtures of them, by shares that are not below 0.
/// The product of two mixtures is at least the least product of what is mixed, and mixing makes both no
/// longer: nowhere is the cosine smaller than the least of those nine. Most triangles are known so at once,
/// and spare their texels two roots.
bool TriangleProjection::facesLight() const {
    constexpr double rounding = 1e-9;
    const Projector& projector = m_layer.projector;
    if (!projector.falloff && !(projector.occlusion && m_layer.blendPixels > 0)) return true;
    Eigen::Matrix3d ways;
    for (Eigen::Index i = 0; i < 3; ++i)
        ways.col(i) = towardsLight(m_corners.col(i));
    const Eigen::Matrix3d cosines = m_normals.transpose() * ways;
    if (!cosines.allFinite()) return false;
    const double outside = cosines.minCoeff(), inside = -cosines.maxCoeff();
    const double least = m_side == SeenSide::Both     ? std::max(outside, inside)
                         : m_side == SeenSide::Inside ? inside
                                                      : outside;
    return least > rounding && weightOfCosine(least - rounding) >= 1;
}

/// What texels in and around the patch read of a photo, where none of it fades.
void TriangleProjection::findClearPart(const Eigen::Vector3d& densities) {
    if (!m_photo.fade || !(m_places.row(2).minCoeff() > 0)) return;
    const Eigen::AlignedBox2d box = boxInPhoto(m_places, densities);
    if (!m_photo.fade->isClear(box)) return;
    m_clearLow = box.min();
    m_clearHigh = box.max();
}

bool TriangleProjection::isInClearPart(double x, double y) const {
    return x >= m_clearLow.x() && x <= m_clearHigh.x() && y >= m_clearLow.y() && y <= m_clearHigh.y();
}

bool TriangleProjection::mayTakeColour(const Eigen::Vector3d& densities) const {
    if (m_places.row(3).maxCoeff() < (isParallel() ? -m_surface.tolerance : 0)) return false;
    if (!(m_places.row(2).minCoeff() > 0)) return true; // reaches behind the eye: corners bound nothing
    const Eigen::AlignedBox2d box = boxInPhoto(m_places, densities);
    return !(box.max().x() < 0 || box.max().y() < 0 || box.min().x() > m_sampler.width() ||
             box.min().y() > m_sampler.height());
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

/// [R 4.3.3]: rises linearly over the distance to the nearest side of the photo. It falls towards outlines as
/// well, beyond which the photo shows other surface, and towards what was erased.
double TriangleProjection::borderWeight(double x, double y) const {
    const double inside = std::min(std::min(x, y), std::min(m_sampler.width() - x, m_sampler.height() - y));
    if (!(inside >= 0)) return 0; // nor for a place that is not finite
    const double fromSide = m_layer.blendPixels > 0 ? std::min(1.0, inside / m_layer.blendPixels) : 1;
    if (!m_photo.fade || isInClearPart(x, y)) return fromSide;
    return fromSide * m_photo.fade->weightAt(x, y);
}

double TriangleProjection::lightWeight(const Eigen::Vector3d& nearest) const {
    const Projector& projector = m_layer.projector;
    const bool mayBeHidden = projector.occlusion && !m_isLit;
    if (m_facesLight && !mayBeHidden) return 1;
    const Eigen::Vector3d way = towardsLight(m_corners * nearest);
    const double weight = m_facesLight ? 1 : angleWeightAt(nearest, way);
    return weight > 0 && mayBeHidden ? weight * seenShare(nearest, way) : weight;
}

/// By a normal that passes smoothly from corner to corner, as in shading (Phong 1975): the triangle's own
/// would give each triangle a weight of its own, and their edges would show.
double TriangleProjection::angleWeightAt(const Eigen::Vector3d& nearest,
                                         const Eigen::Vector3d& towardsLight) const {
    return weightOfCosine(cosineSeen(m_side, (m_normals * nearest).normalized().dot(towardsLight)));
}

/// @param cosine on the side that is seen
double TriangleProjection::weightOfCosine(double cosine) const {
    if (m_layer.projector.falloff) return angleWeight(cosine);
    return m_layer.blendPixels > 0 ? smoothStep(0, grazingCosine, cosine) : 1;
}

Eigen::Vector3d TriangleProjection::towardsLight(const Eigen::Vector3d& point) const {
    const Eigen::Isometry3d& pose = m_layer.projector.pose;
    if (isParallel()) return pose.linear().col(2);
    return (pose.translation() - point).normalized();
}

/// What the light's ray meets first, and by how much that lies before the point. A point within two
/// tolerances of the light has no room for anything between.
double TriangleProjection::seenShare(const Eigen::Vector3d& nearest,
                                     const Eigen::Vector3d& towardsLight) const {
    const Eigen::Vector3d point = m_corners * nearest;
    const double distance = isParallel() ? m_places.row(3).dot(nearest)
                                         : towardsLight.dot(m_layer.projector.pose.translation() - point);
    if (!(distance > 2 * m_surface.tolerance)) return 1;
    const auto hit = m_surface.query->firstHit({point + distance * towardsLight, -towardsLight});
    return hit ? 1 - hiddenShare(distance - hit->distance, m_surface.tolerance) : 1;
}

} // namespace esm
