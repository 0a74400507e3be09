#include "core/dynamics/contact/node_impulses.h"

#include <algorithm>
#include <iterator>

namespace esm {

namespace {

/// Products between so many are 8 MB; one more and all are forgotten.
constexpr std::size_t mostSlots = 1024;

/// How many rows both columns end in.
std::ptrdiff_t commonRows(const HalfColumn& a, const HalfColumn& b) {
    std::ptrdiff_t least = 0, most = std::ssize(a.rows.size() < b.rows.size() ? a.rows : b.rows);
    while (least < most) {
        const std::ptrdiff_t middle = (least + most + 1) / 2;
        if (*(a.rows.end() - middle) == *(b.rows.end() - middle))
            least = middle;
        else
            most = middle - 1;
    }
    return least;
}

/// With A = L·Lᵀ, A⁻¹ between two nodes is the product of their columns of L⁻¹. These lie on the ways from
/// both nodes to the root of the elimination tree, which are the same from where they meet.
double product(const HalfColumn& a, const HalfColumn& b) {
    const std::ptrdiff_t rows = commonRows(a, b);
    const auto last = [rows](const HalfColumn& column) {
        return Eigen::Map<const Eigen::VectorXd>(column.values.data() + column.values.size() - rows, rows);
    };
    return last(a).dot(last(b));
}

} // namespace

void NodeImpulses::addSlot(std::uint32_t node, HalfColumn&& column) {
    const auto slot = static_cast<Eigen::Index>(m_columns.size());
    m_slots[node] = slot;
    m_columns.push_back(std::move(column));
    if (slot >= m_products.rows()) m_products.conservativeResize(2 * slot + 16, 2 * slot + 16);
    for (Eigen::Index other = 0; other <= slot; ++other)
        m_products(slot, other) = m_products(other, slot) =
            product(m_columns.back(), m_columns[static_cast<std::size_t>(other)]);
}

// All that are new are asked for together, which takes a third of the time.
Eigen::MatrixXd NodeImpulses::response(const std::vector<std::uint32_t>& nodes) {
    if (m_columns.size() + nodes.size() > mostSlots) {
        m_slots.clear();
        m_columns.clear();
    }
    std::vector<std::uint32_t> fresh;
    std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(fresh),
                 [&](std::uint32_t node) { return !m_slots.contains(node); });
    std::vector<HalfColumn> columns = m_matrix->halfColumns(fresh);
    for (std::size_t i = 0; i < fresh.size(); ++i)
        addSlot(fresh[i], std::move(columns[i]));
    std::vector<Eigen::Index> slots;
    slots.reserve(nodes.size());
    for (std::uint32_t node : nodes)
        slots.push_back(m_slots.at(node));
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
