#pragma once

#include "core/dynamics/step_matrix.h"

#include <Eigen/Dense>

#include <unordered_map>

namespace esm {

/// How impulses on a few nodes change the velocities of a step, A⁻¹ between those nodes, without a new
/// factorisation. Half columns and their products are kept from step to step for the nodes that come back.
class NodeImpulses {
public:
    explicit NodeImpulses(const StepMatrix& matrix) : m_matrix(&matrix) {}

    /// A⁻¹ between the nodes, 1/kg: the velocity of one per impulse on the other.
    /// Precondition: none is given, each is listed once.
    Eigen::MatrixXd response(const std::vector<std::uint32_t>& nodes);

    /// The node's velocity in a half-solved step. Precondition: the node went through response().
    Eigen::Vector3d velocity(std::uint32_t node, const Vectors& half) const;

    /// Lays an impulse, N·s, on a node in a half-solved step. Precondition: as above.
    void add(std::uint32_t node, const Eigen::Vector3d& impulse, Vectors& half) const;

    /// Gives the nodes their velocities, m/s, in a half-solved step, dragging the others along.
    /// Precondition: none is given, each is listed once.
    void lead(const std::vector<std::uint32_t>& nodes, const Vectors& velocities, Vectors& half);

private:
    void addSlot(std::uint32_t node, HalfColumn&& column);

    const StepMatrix* m_matrix;
    std::unordered_map<std::uint32_t, Eigen::Index> m_slots;
    std::vector<HalfColumn> m_columns; ///< by slot
    Eigen::MatrixXd m_products;        ///< between slots
};

} // namespace esm
