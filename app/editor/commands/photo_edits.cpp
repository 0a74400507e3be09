#include "app/editor/commands/photo_edits.h"

#include "app/editor/commands/move_item.h"

#include "core/support/errors.h"

#include <algorithm>
#include <limits>

namespace esm {

namespace {

/// Nearest point of the organ's box along the view direction, as a distance from the eye.
double nearestDepth(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& eye,
                    const Eigen::Vector3d& direction) {
    double nearest = std::numeric_limits<double>::max();
    for (int corner = 0; corner < 8; ++corner) {
        const auto type = static_cast<Eigen::AlignedBox3d::CornerType>(corner);
        nearest = std::min(nearest, (box.corner(type) - eye).dot(direction));
    }
    return nearest;
}

} // namespace

Projector projectorFromCamera(const Camera& camera, const Image& photo, const TriangleMesh& mesh) {
    const auto box = boundingBox(mesh.vertices);
    const Eigen::Vector3d towards = (camera.target - camera.eye).normalized();
    const Eigen::Vector3d right = towards.cross(camera.up).normalized();
    Eigen::Matrix3d axes;
    axes << right, right.cross(towards), -towards;

    const double extent = 0.4 * box.diagonal().norm();
    const double depth = nearestDepth(box, camera.eye, towards) - 0.1 * extent;
    const double proportion = photo.empty() ? 1 : double(photo.width) / photo.height;
    Projector projector;
    projector.pose.linear() = axes;
    projector.pose.translation() = camera.eye + depth * towards;
    projector.width = proportion >= 1 ? extent : extent * proportion;
    projector.height = projector.width / proportion;
    return projector;
}

Atlas packFitting(const TriangleMesh& mesh, AtlasOptions options) {
    constexpr int largestSize = 8192;
    for (;; options.size *= 2) {
        try {
            return packAtlas(mesh, options);
        } catch (const InvalidModel&) {
            if (options.size * 2 > largestSize) throw;
        }
    }
}

void addPhoto(Project& project, std::shared_ptr<const Photo> photo, const Projector& projector,
              std::shared_ptr<const Atlas> atlas) {
    if (!project.atlas) {
        project.texture.atlas = atlas->options;
        project.atlas = std::move(atlas);
    }
    PhotoLayer layer;
    layer.name = std::filesystem::path(photo->fileName).stem().string();
    layer.photo = std::move(photo);
    layer.projector = projector;
    layer.projector.falloff = true;
    project.photos.push_back(std::move(layer));
}

void removePhoto(Project& project, std::size_t photo) {
    project.photos.erase(project.photos.begin() + static_cast<std::ptrdiff_t>(photo));
}

bool canMovePhoto(const Project& project, std::size_t photo, int above) {
    return canMoveItem(project.photos.size(), photo, above);
}

void movePhoto(Project& project, std::size_t photo, int above) {
    if (canMovePhoto(project, photo, above)) moveItem(project.photos, photo, above);
}

} // namespace esm
