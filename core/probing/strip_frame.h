#pragma once

#include "core/geometry/surface_spot.h"
#include "core/probing/strip.h"

namespace esm {

/// How a strip lies. Its coordinates count from its middle, along, across and out of the organ.
struct StripFrame {
    Eigen::Vector3d place;                  ///< m
    Eigen::Vector3d along, across, outward; ///< of length 1

    Eigen::Vector3d coordinatesOf(const Eigen::Vector3d& point) const {
        const Eigen::Vector3d way = point - place;
        return {way.dot(along), way.dot(across), way.dot(outward)};
    }
};

/// Around a spot of a surface, across the mean direction in which it faces within the strip's width. Of the
/// settings the place is left aside. @throws InvalidModel for a direction through the surface
StripFrame stripFrame(const TriangleMesh& surface, const SurfaceSpot& spot, const StripSettings& settings);

} // namespace esm
