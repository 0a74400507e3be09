#include "core/dynamics/spectrum/rest_matrix.h"

#include "core/dynamics/hinge_force.h"

namespace esm {

namespace {

class BlockEntries {
public:
    explicit BlockEntries(const std::vector<char>& fixed) : m_row(fixed.size(), -1) {
        for (std::size_t i = 0; i < fixed.size(); ++i)
            if (!fixed[i]) m_row[i] = m_rows, m_rows += 3;
    }

    /// Adds what is in the lower half. Fixed nodes have no rows.
    void add(std::uint32_t first, std::uint32_t second, const Eigen::Matrix3d& block) {
        const int row = m_row[first], column = m_row[second];
        if (row < 0 || column < 0 || row < column) return;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                if (row + i >= column + j) m_entries.emplace_back(row + i, column + j, block(i, j));
    }

    Eigen::SparseMatrix<double> matrix() const {
        Eigen::SparseMatrix<double> result(m_rows, m_rows);
        result.setFromTriplets(m_entries.begin(), m_entries.end());
        return result;
    }

private:
    std::vector<int> m_row;
    int m_rows = 0;
    std::vector<Eigen::Triplet<double>> m_entries;
};

/// The columns of a hinge's K at rest for one of its nodes: what all four are pulled by, a block for each.
std::array<Eigen::Matrix3d, 4> stiffnessOfColumn(const SpringSystem::HingeElement& hinge, const Vectors& rest,
                                                 std::size_t place) {
    const BentHinge bent = bentHinge(hinge, ofNodes(hinge, rest));
    std::array<Eigen::Matrix3d, 4> blocks;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        HingeVectors moved;
        moved.fill(Eigen::Vector3d::Zero());
        moved[place] = Eigen::Vector3d::Unit(axis);
        const HingeVectors forces = stiffnessTimes(hinge, bent, false, moved);
        for (std::size_t i = 0; i < 4; ++i)
            blocks[i].col(axis) = forces[i];
    }
    return blocks;
}

void addHinge(const SpringSystem::HingeElement& hinge, const Vectors& rest, const MatrixFactors& factors,
              BlockEntries& entries) {
    for (std::size_t j = 0; j < 4; ++j) {
        const auto stiffness = stiffnessOfColumn(hinge, rest, j);
        for (std::size_t i = 0; i < 4; ++i)
            entries.add(hinge.nodes[i], hinge.nodes[j],
                        factors.damping * hinge.viscosity * hinge.weights[i] * hinge.weights[j] *
                                Eigen::Matrix3d::Identity() +
                            factors.stiffness * stiffness[i]);
    }
}

} // namespace

// At rest no spring has tension, so that none resists being turned: K of a spring is c·n·nᵀ alone. Stretched
// tissue resists more, and bears shorter steps only. What has to hold at any deformation therefore takes the
// Laplacian in its place, which is above K wherever the tissue goes.
Eigen::SparseMatrix<double> restMatrix(const SpringSystem& system, Damping damping,
                                       const MatrixFactors& factors) {
    BlockEntries entries(system.fixed);
    const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
    for (std::uint32_t i = 0; i < system.mass.size(); ++i)
        entries.add(i, i, factors.mass * system.mass[i] * identity);
    const Vectors& rest = system.network->restPositions;
    for (const auto& spring : system.springs) {
        const Eigen::Vector3d direction = (rest[spring.first] - rest[spring.second]).normalized();
        const Eigen::Matrix3d along = direction * direction.transpose();
        const Eigen::Matrix3d damped = damping == Damping::Axial ? along : identity;
        const Eigen::Matrix3d block =
            factors.damping * spring.viscosity * damped + factors.stiffness * spring.springConstant * along;
        entries.add(spring.first, spring.first, block);
        entries.add(spring.second, spring.second, block);
        entries.add(std::max(spring.first, spring.second), std::min(spring.first, spring.second), -block);
    }
    for (const auto& hinge : system.hinges)
        addHinge(hinge, rest, factors, entries);
    for (const Tether& tether : system.tethers)
        entries.add(tether.node, tether.node,
                    (factors.damping * tether.viscosity + factors.stiffness * tether.springConstant) *
                        identity);
    return entries.matrix();
}

} // namespace esm
