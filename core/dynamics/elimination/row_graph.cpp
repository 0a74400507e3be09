#include "core/dynamics/elimination/row_graph.h"

#include <numeric>

namespace esm {

namespace {

template<class Visit> void forEachCoupling(const Eigen::SparseMatrix<double>& lower, const Visit& visit) {
    for (int column = 0; column < lower.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator it(lower, column); it; ++it)
            if (it.row() != column) visit(static_cast<int>(it.row()), column);
}

} // namespace

// Counted first, then laid at their places: two passes, and nothing to sort.
RowGraph::RowGraph(const Eigen::SparseMatrix<double>& lower)
    : m_starts(static_cast<std::size_t>(lower.cols()) + 1, 0) {
    std::vector<std::size_t> counts(m_starts.size(), 0);
    forEachCoupling(lower, [&](int row, int column) {
        ++counts[static_cast<std::size_t>(row)];
        ++counts[static_cast<std::size_t>(column)];
    });
    std::exclusive_scan(counts.begin(), counts.end(), m_starts.begin(), std::size_t{0});
    m_others.resize(m_starts.back());
    std::vector<std::size_t> next(m_starts);
    forEachCoupling(lower, [&](int row, int column) {
        m_others[next[static_cast<std::size_t>(row)]++] = column;
        m_others[next[static_cast<std::size_t>(column)]++] = row;
    });
}

} // namespace esm
