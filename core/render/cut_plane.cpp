#include "core/render/cut_plane.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace esm {
namespace {

using Eigen::Vector3d;

struct SideRow {
    CutSide side;
    std::string_view name;
    Vector3d towards; ///< from the organ's middle
};

/// Names are those of the organ's axes, sides those of its standard views.
const std::array<SideRow, 7>& cutSides() {
    static const std::array<SideRow, 7> rows{{{CutSide::Viewer, "viewer", Vector3d::Zero()},
                                              {CutSide::Right, "+x", Vector3d::UnitX()},
                                              {CutSide::Left, "-x", -Vector3d::UnitX()},
                                              {CutSide::Top, "+y", Vector3d::UnitY()},
                                              {CutSide::Bottom, "-y", -Vector3d::UnitY()},
                                              {CutSide::Front, "+z", Vector3d::UnitZ()},
                                              {CutSide::Back, "-z", -Vector3d::UnitZ()}}};
    return rows;
}

} // namespace

std::string nameOf(CutSide side) {
    return std::string(cutSides()[static_cast<std::size_t>(side)].name);
}

std::optional<CutSide> cutSideFromName(std::string_view name) {
    for (const SideRow& row : cutSides())
        if (row.name == name) return row.side;
    return std::nullopt;
}

/// Of a box seen from a direction the farthest corner lies by the sum of its sides' shadows before the
/// middle.
CutPlane cutPlane(const Cut& cut, const Eigen::AlignedBox3d& organ, const Camera& camera) {
    const Eigen::AlignedBox3d box = drawnBox(organ);
    const Vector3d towards = cutSides()[static_cast<std::size_t>(cut.side)].towards;
    const Vector3d normal = cut.side == CutSide::Viewer ? Vector3d(cameraAxes(camera).col(2)) : towards;
    const double reach = normal.cwiseAbs().dot(box.sizes()) / 2;
    return {normal, normal.dot(box.center()) + reach * (1 - 2 * cut.share)};
}

/// What a plane leaves is one half of space, of which a line has one part.
std::optional<RayPart> leftBy(const std::optional<CutPlane>& cut, const Ray& ray) {
    constexpr double endless = std::numeric_limits<double>::infinity();
    if (!cut) return RayPart{ray, endless};
    const double approach = cut->normal.dot(ray.direction.normalized());
    const double before = cut->offset - cut->normal.dot(ray.origin);
    if (before >= 0) return RayPart{ray, approach > 0 ? before / approach : endless};
    if (!(approach < 0)) return std::nullopt;
    return RayPart{{ray.origin + before / approach * ray.direction.normalized(), ray.direction}, endless};
}

} // namespace esm
