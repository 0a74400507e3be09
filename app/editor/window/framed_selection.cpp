#include "app/editor/window/framed_selection.h"

#include <cmath>

namespace esm {

namespace {

bool isInPhoto(const std::optional<Eigen::Vector3d>& seen, PhotoSize photo) {
    return seen && seen->z() >= 0 && seen->x() >= 0 && seen->y() >= 0 && seen->x() <= photo.width &&
           seen->y() <= photo.height;
}

} // namespace

/// An ellipsoid reaches along each axis of space as far as the root of the sum of its own axes' squares
/// there.
std::optional<Eigen::AlignedBox3d> boxOf(const Region& region) {
    if (!region.ellipsoid) return std::nullopt;
    const Ellipsoid& shape = *region.ellipsoid;
    const Eigen::Matrix3d axes = shape.orientation.toRotationMatrix() * shape.radii.asDiagonal();
    const Eigen::Vector3d reach = axes.rowwise().norm().array() + region.rim;
    return Eigen::AlignedBox3d(shape.centre - reach, shape.centre + reach);
}

std::optional<Eigen::AlignedBox3d> boxOf(const TextureLayer& layer, const TriangleMesh& mesh) {
    const auto picture = pictureOf(layer);
    if (!layer.photo || !picture || picture->empty()) return std::nullopt;
    const PhotoSize photo = sizeOf(*picture);
    const Projector& projector = layer.projector;
    const std::vector<Eigen::Vector3d> normals = vertexNormals(mesh.vertices, mesh.triangles);
    Eigen::AlignedBox3d shown;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const Eigen::Vector3d& vertex = mesh.vertices[i];
        const Eigen::Vector3d towards = projector.kind == ProjectorKind::Parallel
                                            ? Eigen::Vector3d(projector.pose.linear().col(2))
                                            : Eigen::Vector3d(projector.pose.translation() - vertex);
        if (normals[i].dot(towards) > 0 && isInPhoto(project(projector, photo, vertex), photo))
            shown.extend(vertex);
    }
    if (!shown.isEmpty()) return shown;
    for (const Eigen::Vector3d& corner : photoCorners(projector, photo, 0.1))
        shown.extend(corner);
    return shown;
}

} // namespace esm
