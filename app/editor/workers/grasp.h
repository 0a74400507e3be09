#pragma once

#include "core/dynamics/simulation.h"
#include "core/model/gentle_pull.h"

#include <cstdint>
#include <vector>

namespace esm {

/// A patch of tissue taken hold of: it follows a displacement, not a place, and swiftly but not at once, so
/// that a jump of the mouse is no blow [R 4.4].
class Grasp {
public:
    Grasp(const TissueModel& model, const std::vector<Eigen::Vector3d>& positions, std::uint32_t node);

    std::uint32_t node() const { return m_node; }
    /// All that it holds.
    const std::vector<std::uint32_t>& nodes() const { return m_nodes; }
    /// Where the grasped node shall go.
    void setTarget(const Eigen::Vector3d& target) { m_target = target - m_start.front(); }
    void setDisplacement(const Eigen::Vector3d& displacement) { m_target = displacement; }

    /// Moves on by `timeStep` (s) and adds the held nodes.
    void advance(double timeStep, std::vector<PrescribedNode>& prescribed);

private:
    std::uint32_t m_node;
    std::vector<std::uint32_t> m_nodes; ///< the grasped one first
    std::vector<Eigen::Vector3d> m_start;
    Eigen::Vector3d m_target = Eigen::Vector3d::Zero(), m_displacement = Eigen::Vector3d::Zero();
};

/// A gentle pull that goes out and is let back again, over and over.
Eigen::Vector3d displacementAt(const GentlePull& pull, double time);

} // namespace esm
