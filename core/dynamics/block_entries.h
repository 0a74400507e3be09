#pragma once

#include <Eigen/Sparse>

#include <cstdint>
#include <vector>

namespace esm {

/// The lower half of a symmetric matrix over the coordinates x, y, z of the nodes that are not fixed, three
/// rows each in the order of the nodes, put together block by block.
class BlockEntries {
public:
    explicit BlockEntries(const std::vector<char>& fixed);

    /// The first of a node's three rows; −1 of a fixed one.
    int rowOf(std::uint32_t node) const { return m_row[node]; }

    int rowCount() const { return m_rows; }

    /// Adds what of a block lies in the lower half. Fixed nodes have no rows.
    void add(std::uint32_t first, std::uint32_t second, const Eigen::Matrix3d& block);
    /// The same of what acts between two nodes alone: a block at each, and what they take from each other.
    void addBetween(std::uint32_t first, std::uint32_t second, const Eigen::Matrix3d& block);

    /// The same to every row: all nodes are tied to where they are by so much.
    void addToDiagonal(double number);

    Eigen::SparseMatrix<double> matrix() const;

private:
    std::vector<int> m_row;
    int m_rows = 0;
    std::vector<Eigen::Triplet<double>> m_entries;
};

} // namespace esm
