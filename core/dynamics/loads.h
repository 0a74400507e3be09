#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace esm {

/// A sphere that pushes the surface out of its way. Within one step it may move 32 radii; moved farther, it
/// may pass through thin tissue. Where nothing can give way, as between fixed nodes, it passes.
struct Sphere {
    Eigen::Vector3d centre; ///< m
    double radius;          ///< m
};

/// A node led to a place; its velocity is what takes it there in one step of the integrator.
struct HeldNode {
    std::uint32_t node;
    Eigen::Vector3d position; ///< m, at the end of the step
};

/// What acts on the tissue during one step.
struct Loads {
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero();             ///< m/s²
    std::vector<std::pair<std::uint32_t, Eigen::Vector3d>> forces; ///< node, N
    std::vector<HeldNode> held;
    std::optional<Sphere> instrument; ///< where it is at the end of the step
    /// What builds on earlier steps begins anew: a load begins, ends or turns since the last step's
    /// beginning.
    bool beginsAnew = false;
};

} // namespace esm
