#pragma once

#include <Eigen/SparseCore>

#include <span>
#include <vector>

namespace esm {

/// Which rows of a symmetric matrix are coupled: where it has entries beside the diagonal.
class RowGraph {
public:
    /// @param lower its lower half
    explicit RowGraph(const Eigen::SparseMatrix<double>& lower);

    std::size_t rowCount() const { return m_starts.size() - 1; }
    std::span<const int> coupledTo(int row) const {
        const auto r = static_cast<std::size_t>(row);
        return {m_others.data() + m_starts[r], m_starts[r + 1] - m_starts[r]};
    }

private:
    std::vector<std::size_t> m_starts; ///< per row and one more: where those coupled to it begin
    std::vector<int> m_others;
};

} // namespace esm
