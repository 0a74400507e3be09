#include "core/texture/projection/photo_reach.h"

#include <algorithm>
#include <vector>

namespace esm {

namespace {

/// Of corners as `photoMatrix` gives them. A triangle that reaches behind the eye is bounded by nothing.
bool mayMeet(const Eigen::Matrix<double, 4, 3>& corners, PhotoSize photo) {
    if (!(corners.row(2).maxCoeff() > 0) || !(corners.row(3).maxCoeff() >= 0)) return false;
    if (!(corners.row(2).minCoeff() > 0)) return true;
    const Eigen::Matrix<double, 2, 3> pixels =
        corners.topRows<2>().array().rowwise() / corners.row(2).array();
    const Eigen::Vector2d low = pixels.rowwise().minCoeff(), high = pixels.rowwise().maxCoeff();
    return low.x() < photo.width && low.y() < photo.height && high.x() > 0 && high.y() > 0;
}

} // namespace

bool mayMeet(const Projector& projector, PhotoSize photo, const TriangleMesh& mesh) {
    const Eigen::Matrix4d matrix = photoMatrix(projector, photo);
    std::vector<Eigen::Vector4d> seen;
    seen.reserve(mesh.vertices.size());
    for (const Eigen::Vector3d& vertex : mesh.vertices)
        seen.emplace_back(matrix * vertex.homogeneous());
    return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& triangle) {
        Eigen::Matrix<double, 4, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners.col(static_cast<Eigen::Index>(i)) = seen[triangle[i]];
        return mayMeet(corners, photo);
    });
}

} // namespace esm
