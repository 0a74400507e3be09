#pragma once

#include "core/solid/lattice_elasticity.h"
#include "core/solid/prism_wall.h"

#include <Eigen/SparseCholesky>

#include <cmath>
#include <optional>
#include <vector>

namespace esm::test {

/// Springs whose nodes go where they must, the others where they balance.
class WallBalance {
public:
    explicit WallBalance(const PrismWall& wall) : m_wall(wall), m_given(3 * wall.nodes.size()) {}

    /// @param axis 0 to 2
    void lead(std::size_t node, int axis, double by) {
        m_given[3 * node + static_cast<std::size_t>(axis)] = by;
    }

    /// J, of springs with these constants
    double energy() const {
        std::vector<int> numbers(m_given.size(), -1);
        int count = 0;
        for (std::size_t i = 0; i < m_given.size(); ++i)
            if (!m_given[i]) numbers[i] = count++;
        std::vector<Eigen::Triplet<double>> entries;
        Eigen::VectorXd load = Eigen::VectorXd::Zero(count);
        double constant = 0;
        for (const LatticeSpring& spring : m_wall.springs) {
            const Eigen::Matrix<double, 6, 1> row = rowOf(spring);
            double given = 0;
            for (int i = 0; i < 6; ++i)
                given += row[i] * m_given[placeOf(spring, i)].value_or(0);
            constant += given * given / 2;
            for (int i = 0; i < 6; ++i) {
                const int one = numbers[placeOf(spring, i)];
                if (one < 0) continue;
                load[one] -= row[i] * given;
                for (int j = 0; j < 6; ++j)
                    if (const int other = numbers[placeOf(spring, j)]; other >= 0)
                        entries.emplace_back(one, other, row[i] * row[j]);
            }
        }
        Eigen::SparseMatrix<double> matrix(count, count);
        matrix.setFromTriplets(entries.begin(), entries.end());
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
        return constant - load.dot(factor.solve(load)) / 2;
    }

private:
    static std::size_t placeOf(const LatticeSpring& spring, int i) {
        return 3 * std::size_t{i < 3 ? spring.first : spring.second} + static_cast<std::size_t>(i % 3);
    }
    /// How much longer it becomes per way of its ends, times the root of its constant.
    Eigen::Matrix<double, 6, 1> rowOf(const LatticeSpring& spring) const {
        const Eigen::Vector3d along = (m_wall.nodes[spring.second] - m_wall.nodes[spring.first]).normalized();
        Eigen::Matrix<double, 6, 1> row;
        row << -along, along;
        return std::sqrt(spring.constant) * row;
    }

    const PrismWall& m_wall;
    std::vector<std::optional<double>> m_given;
};

/// A wall of tissue of that modulus, Pa.
inline PrismWall wallOfTissue(const TriangleMesh& mesh, const LatticeFilling& filling, double youngsModulus) {
    PrismWall wall = prismWall(mesh, filling);
    for (LatticeSpring& spring : wall.springs)
        spring.constant *= latticeConstant(filling, youngsModulus);
    return wall;
}

} // namespace esm::test
