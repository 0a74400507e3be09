#include "core/probing/strip_frame.h"

#include "core/support/errors.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <array>

namespace esm {

namespace {

using Eigen::Vector3d;

constexpr double leastSlant = 0.2; ///< of a direction that lies along a surface, as a sine

/// The directions in which an organ is longest, longest first.
std::array<Vector3d, 3> longDirections(const std::vector<Vector3d>& nodes) {
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& node : nodes)
        middle += node / static_cast<double>(nodes.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vector3d& node : nodes)
        spread += (node - middle) * (node - middle).transpose();
    const Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();
    return {axes.col(2), axes.col(1), axes.col(0)};
}

/// What of a direction lies along a surface; none where it points through it.
std::optional<Vector3d> alongSurface(const Vector3d& direction, const Vector3d& outward) {
    const Vector3d unit = direction.stableNormalized();
    const Vector3d flat = unit - unit.dot(outward) * outward;
    if (!(flat.norm() > leastSlant)) return {};
    return flat.normalized();
}

// Where nobody says it, a strip lies as it is cut out of organs: along a bowel, a vessel, a lobe.
Vector3d directionOf(const std::vector<Vector3d>& places, const StripSettings& settings,
                     const Vector3d& outward) {
    if (settings.along) {
        const auto along =
            settings.along->allFinite() ? alongSurface(*settings.along, outward) : std::nullopt;
        if (!along)
            throw InvalidModel("the strip's direction must be three finite numbers that point along the "
                               "organ's surface at the place, not through it");
        return *along;
    }
    for (const Vector3d& direction : longDirections(places))
        if (const auto along = alongSurface(direction, outward)) return *along;
    return outward.unitOrthogonal();
}

} // namespace

StripFrame stripFrame(const TriangleMesh& surface, const SurfaceSpot& spot, const StripSettings& settings) {
    const Vector3d outward = outwardAround(surface, spot, settings.width / 2);
    const Eigen::AngleAxisd turn(settings.turn, outward);
    const Vector3d along = turn * directionOf(surface.vertices, settings, outward);
    return {spot.point, along, outward.cross(along), outward};
}

} // namespace esm
