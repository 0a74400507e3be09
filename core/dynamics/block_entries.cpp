#include "core/dynamics/block_entries.h"

#include <algorithm>

namespace esm {

BlockEntries::BlockEntries(const std::vector<char>& fixed) : m_row(fixed.size(), -1) {
    for (std::size_t i = 0; i < fixed.size(); ++i)
        if (!fixed[i]) m_row[i] = m_rows, m_rows += 3;
}

void BlockEntries::add(std::uint32_t first, std::uint32_t second, const Eigen::Matrix3d& block) {
    const int row = m_row[first], column = m_row[second];
    if (row < 0 || column < 0 || row < column) return;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (row + i >= column + j) m_entries.emplace_back(row + i, column + j, block(i, j));
}

void BlockEntries::addBetween(std::uint32_t first, std::uint32_t second, const Eigen::Matrix3d& block) {
    add(first, first, block);
    add(second, second, block);
    add(std::max(first, second), std::min(first, second), -block);
}

void BlockEntries::addToDiagonal(double number) {
    for (int row = 0; row < m_rows; ++row)
        m_entries.emplace_back(row, row, number);
}

Eigen::SparseMatrix<double> BlockEntries::matrix() const {
    Eigen::SparseMatrix<double> result(m_rows, m_rows);
    result.setFromTriplets(m_entries.begin(), m_entries.end());
    return result;
}

} // namespace esm
