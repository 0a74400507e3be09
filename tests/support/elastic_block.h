#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

/// Linear finite elements: a block of an even solid, pressed by a sphere. It shares nothing with the program.
namespace esm::test {

/// A quarter of a block, from its middle (0, 0, 0) on its upper face to a corner below. Its lower face is
/// fixed; the planes x = 0 and y = 0 are those of symmetry.
struct ElasticBlock {
    double width, height; ///< m, of the quarter
    double youngsModulus; ///< Pa
    double poissonsRatio;
    int cells; ///< along each side; smaller ones by the middle
};

/// Stiffness of a tetrahedron with linear displacements.
inline Eigen::Matrix<double, 12, 12> tetrahedronStiffness(const std::array<Eigen::Vector3d, 4>& corners,
                                                          const ElasticBlock& block) {
    Eigen::Matrix4d places;
    for (int i = 0; i < 4; ++i)
        places.row(i) << 1, corners[static_cast<std::size_t>(i)].transpose();
    const Eigen::Matrix4d gradients = places.inverse(); // below the first row, one column per corner
    Eigen::Matrix<double, 6, 12> strains = Eigen::Matrix<double, 6, 12>::Zero();
    for (int i = 0; i < 4; ++i) {
        const double x = gradients(1, i), y = gradients(2, i), z = gradients(3, i);
        strains.block<6, 3>(0, 3 * i) << x, 0, 0, 0, y, 0, 0, 0, z, 0, z, y, z, 0, x, y, x, 0;
    }
    const double nu = block.poissonsRatio, e = block.youngsModulus;
    const double lambda = e * nu / ((1 + nu) * (1 - 2 * nu)), mu = e / (2 * (1 + nu));
    Eigen::Matrix<double, 6, 6> law = Eigen::Matrix<double, 6, 6>::Zero();
    law.topLeftCorner<3, 3>().setConstant(lambda);
    law.diagonal() << lambda + 2 * mu, lambda + 2 * mu, lambda + 2 * mu, mu, mu, mu;
    return std::abs(places.determinant()) / 6 * strains.transpose() * law * strains;
}

class PressedBlock {
public:
    explicit PressedBlock(const ElasticBlock& block) : m_block(block), m_side(block.cells + 1) { assemble(); }

    /// N, on a frictionless sphere that is pressed into the whole block's middle. Small displacements: the
    /// face keeps below a paraboloid, by pushes that only push (Gauss-Seidel over the face's compliance).
    double force(double radius, double depth) {
        std::vector<int> nodes;
        for (int y = 0; y < m_side; ++y)
            for (int x = 0; x < m_side; ++x)
                if (gap(x, y, radius) < depth && rowOf(index(x, y, 0)) >= 0) nodes.push_back(index(x, y, 0));
        const auto count = static_cast<Eigen::Index>(nodes.size());
        Eigen::MatrixXd compliance(count, count);
        Eigen::VectorXd needed(count), pushes = Eigen::VectorXd::Zero(count);
        for (Eigen::Index i = 0; i < count; ++i) {
            Eigen::VectorXd unit = Eigen::VectorXd::Zero(m_rows);
            const int node = nodes[static_cast<std::size_t>(i)];
            unit[rowOf(node)] = 1;
            const Eigen::VectorXd moved = m_solver.solve(unit);
            for (Eigen::Index j = 0; j < count; ++j)
                compliance(j, i) = moved[rowOf(nodes[static_cast<std::size_t>(j)])];
            needed[i] = depth - gap(node % m_side, node / m_side, radius);
        }
        for (int sweep = 0; sweep < 20000; ++sweep)
            for (Eigen::Index i = 0; i < count; ++i)
                pushes[i] =
                    std::max(0.0, pushes[i] + (needed[i] - compliance.row(i).dot(pushes)) / compliance(i, i));
        return 4 * pushes.sum();
    }

private:
    int index(int x, int y, int z) const { return (z * m_side + y) * m_side + x; }
    Eigen::Index rowOf(int node) const { return m_row[static_cast<std::size_t>(3 * node + 2)]; }
    /// Cells grow away from the middle.
    double along(int i, double whole) const {
        return whole * std::pow(static_cast<double>(i) / m_block.cells, 1.7);
    }
    double gap(int x, int y, double radius) const {
        return (std::pow(along(x, m_block.width), 2) + std::pow(along(y, m_block.width), 2)) / (2 * radius);
    }
    Eigen::Vector3d placeOf(int x, int y, int z) const {
        return {along(x, m_block.width), along(y, m_block.width), -along(z, m_block.height)};
    }

    void assemble() {
        const int nodes = m_side * m_side * m_side;
        m_row.assign(static_cast<std::size_t>(3 * nodes), -1);
        for (int z = 0; z + 1 < m_side; ++z)
            for (int y = 0; y < m_side; ++y)
                for (int x = 0; x < m_side; ++x)
                    for (int axis = 0; axis < 3; ++axis)
                        if (!(axis == 0 && x == 0) && !(axis == 1 && y == 0))
                            m_row[static_cast<std::size_t>(3 * index(x, y, z) + axis)] = m_rows++;
        std::vector<Eigen::Triplet<double>> entries;
        for (int z = 0; z < m_block.cells; ++z)
            for (int y = 0; y < m_block.cells; ++y)
                for (int x = 0; x < m_block.cells; ++x)
                    addCell({x, y, z}, entries);
        Eigen::SparseMatrix<double> matrix(m_rows, m_rows);
        matrix.setFromTriplets(entries.begin(), entries.end());
        m_solver.compute(matrix);
    }

    /// Six tetrahedra about the cell's diagonal (Kuhn).
    void addCell(const std::array<int, 3>& cell, std::vector<Eigen::Triplet<double>>& entries) const {
        std::array<int, 3> order{0, 1, 2};
        do {
            std::array<int, 3> at = cell;
            std::array<int, 4> nodes{index(at[0], at[1], at[2])};
            std::array<Eigen::Vector3d, 4> corners{placeOf(at[0], at[1], at[2])};
            for (std::size_t i = 0; i < 3; ++i) {
                ++at[static_cast<std::size_t>(order[i])];
                nodes[i + 1] = index(at[0], at[1], at[2]);
                corners[i + 1] = placeOf(at[0], at[1], at[2]);
            }
            const auto stiffness = tetrahedronStiffness(corners, m_block);
            for (int i = 0; i < 12; ++i)
                for (int j = 0; j < 12; ++j) {
                    const int row =
                        m_row[static_cast<std::size_t>(3 * nodes[static_cast<std::size_t>(i / 3)] + i % 3)];
                    const int column =
                        m_row[static_cast<std::size_t>(3 * nodes[static_cast<std::size_t>(j / 3)] + j % 3)];
                    if (row >= 0 && column >= 0) entries.emplace_back(row, column, stiffness(i, j));
                }
        } while (std::next_permutation(order.begin(), order.end()));
    }

    ElasticBlock m_block;
    int m_side, m_rows = 0;
    std::vector<int> m_row; ///< by node and axis; −1: it does not move
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_solver;
};

} // namespace esm::test
