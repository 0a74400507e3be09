#pragma once

#include "core/render/renderer.h"

#include <Eigen/Core>

namespace esm {

/// What all parts of one picture share. Positions go to the graphics card as float, relative to `origin`.
struct Frame {
    Eigen::Vector3d origin; ///< m; the shown organ's middle at rest, so that float suffices anywhere in space
    Eigen::Vector3d eye;    ///< m; far off without perspective: see `viewpoint`
    float
        exposedDistance; ///< m from the eye, at which an endoscope's light is neither too bright nor too dark
    Eigen::Matrix4f view, projection; ///< `view` takes positions relative to `origin`
    Eigen::Vector4f cut{0, 0, 0, 1};  ///< in the view's space: what it gives below 0 is hidden
    Eigen::Vector2f pixels;           ///< of the whole picture
    float pixelRatio;                 ///< pixels per pixel of the design: line widths are multiples of it
    float size;                       ///< m, diagonal of the organ's box

    Eigen::Vector3f local(const Eigen::Vector3d& point) const { return (point - origin).cast<float>(); }
};

/// Red, green, blue from 0 to 1.
inline Eigen::Vector3f toFloat(const Colour& colour) {
    return Eigen::Vector3f(colour[0], colour[1], colour[2]) / 255.0F;
}

} // namespace esm
