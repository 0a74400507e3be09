#include "core/texture/maps/patch_frame.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <cmath>

namespace esm {

namespace {

/// Metres of the surface per texel to the right and downwards, as columns; nothing for a patch or a triangle
/// without area.
std::optional<Eigen::Matrix<double, 3, 2>> metresPerStep(const std::array<Eigen::Vector3d, 3>& corners,
                                                         const std::array<Eigen::Vector2d, 3>& patch) {
    Eigen::Matrix2d texels;
    texels << patch[1] - patch[0], patch[2] - patch[0];
    Eigen::Matrix<double, 3, 2> sides;
    sides << corners[1] - corners[0], corners[2] - corners[0];
    Eigen::Matrix2d inverse;
    bool isInvertible = false;
    texels.computeInverseWithCheck(inverse, isInvertible);
    if (!isInvertible || !(sides.col(0).cross(sides.col(1)).norm() > 0)) return std::nullopt;
    return Eigen::Matrix<double, 3, 2>(sides * inverse);
}

} // namespace

/// The gradient g in the plane is what both steps say of it: g · right and g · down are the heights gained.
/// Written in tangent and bitangent that is a triangular system, also where the patch is no similar picture
/// of its triangle.
std::optional<PatchFrame> patchFrame(const TriangleMesh& mesh, const Atlas& atlas, std::uint32_t triangle) {
    const Triangle& at = mesh.triangles[triangle];
    const std::array<Eigen::Vector3d, 3> corners{mesh.vertices[at[0]], mesh.vertices[at[1]],
                                                 mesh.vertices[at[2]]};
    PatchFrame frame{Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ(), 1, Eigen::Matrix2d::Zero()};
    const auto steps = metresPerStep(corners, atlas.corners[triangle]);
    if (!steps) return std::nullopt;
    const Eigen::Vector3d right = steps->col(0), down = steps->col(1);
    frame.normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    frame.tangent = right.normalized();
    const Eigen::Vector3d across = frame.normal.cross(frame.tangent);
    frame.handedness = across.dot(down) < 0 ? 1 : -1;
    const Eigen::Vector3d bitangent = frame.handedness * across;
    const double perRight = 1 / right.norm(), perDown = 1 / bitangent.dot(down);
    frame.slopesOf << perRight, 0, -frame.tangent.dot(down) * perRight * perDown, perDown;
    if (!frame.slopesOf.allFinite()) frame.slopesOf.setZero();
    return frame;
}

} // namespace esm
