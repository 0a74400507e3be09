#pragma once

#include "tests/support/solid_surfaces.h"

#include <algorithm>

/// A surface that runs through itself in one small place.
namespace esm::test {

/// A ball of radius 1 with two spikes as high as a tenth of it, the tip of one within the other.
inline TriangleMesh crossedBall() {
    TriangleMesh mesh = ball(1, Eigen::Vector3d::Zero(), 48);
    const auto nearest = [&](const Eigen::Vector3d& place) -> Eigen::Vector3d& {
        return *std::min_element(mesh.vertices.begin(), mesh.vertices.end(),
                                 [&](const auto& one, const auto& other) {
                                     return (one - place).norm() < (other - place).norm();
                                 });
    };
    const Eigen::Vector3d foot = nearest(Eigen::Vector3d::UnitX());
    Eigen::Vector3d& other = nearest(foot + 0.2 * foot.unitOrthogonal());
    nearest(foot) = 1.1 * foot;
    other = 1.045 * foot;
    return mesh;
}

} // namespace esm::test
