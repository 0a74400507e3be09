#include "core/texture/layers/photo_ray.h"

namespace esm {

Ray rayThrough(const Projector& projector, PhotoSize photo, const Eigen::Vector2d& pixel) {
    if (projector.kind == ProjectorKind::Perspective) {
        const Intrinsics camera = intrinsicsOf(projector, photo);
        const Eigen::Vector3d direction((pixel.x() - camera.cx) / camera.fx,
                                        (camera.cy - pixel.y()) / camera.fy, -1);
        return {projector.pose.translation(), projector.pose.linear() * direction};
    }
    const Eigen::Vector3d origin((pixel.x() / photo.width - 0.5) * projector.width,
                                 (0.5 - pixel.y() / photo.height) * projector.height, 0);
    return {projector.pose * origin, -projector.pose.linear().col(2)};
}

} // namespace esm
