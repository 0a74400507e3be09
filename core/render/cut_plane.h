#pragma once

#include "core/render/camera.h"

#include <optional>
#include <string>
#include <string_view>

namespace esm {

/// Hides all that lies beyond it.
struct CutPlane {
    Eigen::Vector3d normal{0, 0, 1}; ///< of length 1, towards what is hidden
    double offset = 0;               ///< m, of the plane along it from the origin

    bool hides(const Eigen::Vector3d& point) const { return normal.dot(point) > offset; }
};

/// From which side an organ is cut open: from the viewer's, or from where one of its axes points.
enum class CutSide { Viewer, Right, Left, Top, Bottom, Front, Back };

/// A cut as people set it: wherever the organ is, however large.
struct Cut {
    CutSide side = CutSide::Viewer;
    double share = 0.5; ///< of the organ's length from that side that is hidden, 0 to 1

    bool operator==(const Cut&) const = default;
};

/// "viewer", "+x", "-x", "+y", "-y", "+z" or "-z".
std::string nameOf(CutSide side);
std::optional<CutSide> cutSideFromName(std::string_view name);

/// @param organ the box of what is cut
CutPlane cutPlane(const Cut& cut, const Eigen::AlignedBox3d& organ, const Camera& camera);

/// The part of a ray that a cut leaves. None where nothing is left.
struct RayPart {
    Ray ray;
    double length; ///< m; infinite where it never goes beyond the plane
};
std::optional<RayPart> leftBy(const std::optional<CutPlane>& cut, const Ray& ray);

} // namespace esm
