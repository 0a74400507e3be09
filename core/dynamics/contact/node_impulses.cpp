#include "core/dynamics/contact/node_impulses.h"

namespace esm {

namespace {

/// Products between so many are 8 MB; one more and all are forgotten.
constexpr std::size_t mostSlots = 1024;

/// With A = L·Lᵀ, A⁻¹ between two nodes is the product of their columns of L⁻¹. These lie on the ways from
/// both nodes to the root of the elimination tree, which are the same from where they meet: gone through from
/// the root, the product ends at the first rows that differ.

double product(const HalfColumn& a, const HalfColumn& b) {
    double sum = 0;
    for (std::size_t i = a.rows.size(), j = b.rows.size(); i-- > 0 && j-- > 0 && a.rows[i] == b.rows[j];)
        sum += a.values[i] * b.values[j];
    return sum;
}

} // namespace

Eigen::Index NodeImpulses::slotOf(std::uint32_t node) {
    const auto [found, isNew] = m_slots.try_emplace(node, static_cast<Eigen::Index>(m_columns.size()));
    if (!isNew) return found->second;
    const Eigen::Index slot = found->second;
    m_columns.push_back(m_matrix->halfColumn(node));
    if (slot >= m_products.rows()) m_products.conservativeResize(2 * slot + 16, 2 * slot + 16);
    for (Eigen::Index other = 0; other <= slot; ++other)
        m_products(slot, other) = m_products(other, slot) =
            product(m_columns.back(), m_columns[static_cast<std::size_t>(other)]);
    return slot;
}

Eigen::MatrixXd NodeImpulses::response(const std::vector<std::uint32_t>& nodes) {
    if (m_columns.size() + nodes.size() > mostSlots) {
        m_slots.clear();
        m_columns.clear();
    }
    std::vector<Eigen::Index> slots;
    slots.reserve(nodes.size());
    for (std::uint32_t node : nodes)
        slots.push_back(slotOf(node));
    return m_products(slots, slots);
}

Eigen::Vector3d NodeImpulses::velocity(std::uint32_t node, const Vectors& half) const {
    const HalfColumn& column = m_columns[static_cast<std::size_t>(m_slots.at(node))];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < column.rows.size(); ++i)
        sum += column.values[i] * half[static_cast<std::size_t>(column.rows[i])];
    return sum;
}

void NodeImpulses::add(std::uint32_t node, const Eigen::Vector3d& impulse, Vectors& half) const {
    const HalfColumn& column = m_columns[static_cast<std::size_t>(m_slots.at(node))];
    for (std::size_t i = 0; i < column.rows.size(); ++i)
        half[static_cast<std::size_t>(column.rows[i])] += column.values[i] * impulse;
}

// Each impulse on one led node moves the others too, so that all are found together.
void NodeImpulses::lead(const std::vector<std::uint32_t>& nodes, const Vectors& velocities, Vectors& half) {
    const auto factorisation = response(nodes).llt();
    Eigen::MatrixX3d change(nodes.size(), 3);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        change.row(static_cast<Eigen::Index>(i)) = velocities[nodes[i]] - velocity(nodes[i], half);
    const Eigen::MatrixX3d impulses = factorisation.solve(change);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        add(nodes[i], impulses.row(static_cast<Eigen::Index>(i)), half);
}

} // namespace esm
