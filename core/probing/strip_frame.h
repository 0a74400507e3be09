#pragma once

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

/// Across the mean direction in which the surface faces within the strip's width.
/// @throws InvalidModel for a place off the surface, or a direction through it
StripFrame stripFrame(const ProbedOrgan& organ, const StripSettings& settings);

} // namespace esm
