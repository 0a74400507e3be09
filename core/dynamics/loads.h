#pragma once

#include "core/geometry/collider.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace esm {

/// A node led to a place; its velocity is what takes it there in one step of the integrator.
struct PrescribedNode {
    std::uint32_t node;
    Eigen::Vector3d position; ///< m, at the end of the step
};

/// What presses from within on a cavity's wall, beside its fluid's own stiffness.
struct CavityPressure {
    std::uint32_t part;
    double before, after; ///< Pa, at the step's two ends; even between

    double mean() const { return 0.5 * (before + after); }

    bool operator==(const CavityPressure&) const = default;
};

/// What acts on the tissue during one step.
struct Loads {
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero();             ///< m/s²
    std::vector<std::pair<std::uint32_t, Eigen::Vector3d>> forces; ///< node, N
    std::vector<PrescribedNode> prescribed;
    std::vector<CavityPressure> pressures; ///< of cavities of the tissue, each once
    /// Where each instrument is at the end of the step; the n-th is the same one in every step. They push the
    /// surface out of their way. Within one step an instrument may move 32 radii; moved farther, it may pass
    /// through thin tissue. Where nothing can give way, as between fixed nodes, it passes.
    std::vector<PlacedCollider> instruments;
    /// What builds on earlier steps begins anew: a load begins, ends or turns since the last step's
    /// beginning.
    bool beginsAnew = false;
};

} // namespace esm
