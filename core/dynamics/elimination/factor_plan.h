#pragma once

#include <Eigen/SparseCore>

#include <span>
#include <vector>

namespace esm {

/// Columns of a factor that lie side by side and share their rows: a dense panel, column after column. Its
/// upper rows are those of its own columns, a triangle; the others follow.
struct FactorBlock {
    int begin = 0, end = 0;     ///< its columns
    std::size_t firstBelow = 0; ///< where its other rows begin among those of all blocks
    std::size_t belowCount = 0;
    std::size_t values = 0; ///< where its panel begins among all values

    std::size_t width() const { return static_cast<std::size_t>(end - begin); }
    std::size_t height() const { return width() + belowCount; }
};

/// What a block has to do with others while it is computed.
struct BlockLinks {
    std::vector<int> children;       ///< blocks that change no block before this one
    std::vector<int> placesInParent; ///< of the rows below, among the rows of the block they change first
};

/// Where the entries of a matrix's Cholesky factor are, and how it is computed: all that does not depend on
/// what the entries are.
struct FactorPlan {
    std::vector<int> places;          ///< by row of the matrix, its row in the factor
    std::vector<FactorBlock> blocks;  ///< in the order in which they are eliminated
    std::vector<int> rowsBelow;       ///< block after block, of each increasing
    std::vector<BlockLinks> links;    ///< by block
    std::vector<std::size_t> targets; ///< by entry of the matrix, its place among the values
    std::size_t valueCount = 0;
    std::size_t mostRows = 0; ///< of a block

    /// A block's rows after those of its own columns.
    std::span<const int> below(const FactorBlock& block) const {
        return {rowsBelow.data() + block.firstBelow, block.belowCount};
    }
};

/// @param lower half of a symmetric matrix, its diagonal complete
/// @param places of its rows, m: see dissect()
FactorPlan planFactor(const Eigen::SparseMatrix<double>& lower, const std::vector<Eigen::Vector3d>& places);

} // namespace esm
