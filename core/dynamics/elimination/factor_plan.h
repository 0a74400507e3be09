#pragma once

#include <Eigen/SparseCore>

#include <vector>

namespace esm {

/// Columns of a factor that lie side by side and share their rows: a dense panel, column after column. Its
/// upper rows are those of its own columns, a triangle; the others follow.
struct FactorBlock {
    int begin = 0, end = 0;            ///< its columns
    std::vector<int> below;            ///< its rows after those, increasing
    std::size_t values = 0;            ///< where its panel begins among all values
    std::vector<int> children;         ///< blocks that change no block before this one
    std::vector<int> placesInParent{}; ///< of the rows below, among the rows of the block they change first

    std::size_t width() const { return static_cast<std::size_t>(end - begin); }
    std::size_t height() const { return width() + below.size(); }
};

/// Where the entries of a matrix's Cholesky factor are, and how it is computed: all that does not depend on
/// what the entries are.
struct FactorPlan {
    std::vector<int> places;          ///< by row of the matrix, its row in the factor
    std::vector<FactorBlock> blocks;  ///< in the order in which they are eliminated
    std::vector<std::size_t> targets; ///< by entry of the matrix, its place among the values
    std::size_t valueCount = 0;
    std::size_t mostRows = 0; ///< of a block
};

/// @param lower half of a symmetric matrix, its diagonal complete
/// @param places of its rows, m: see dissect()
FactorPlan planFactor(const Eigen::SparseMatrix<double>& lower, const std::vector<Eigen::Vector3d>& places);

} // namespace esm
