#include "core/dynamics/elimination/elimination_tree.h"

#include "tests/support/rounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

using namespace esm;

namespace {

using Entries = std::vector<std::vector<char>>;

/// A symmetric matrix with few entries, its rows shuffled.
Eigen::SparseMatrix<double> sparseLower(int rows, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<Eigen::Triplet<double>> entries;
    for (int row = 0; row < rows; ++row) {
        entries.emplace_back(row, row, 1);
        for (int column = 0; column < row; ++column)
            if (random() % static_cast<unsigned>(rows) < 2) entries.emplace_back(row, column, 1);
    }
    Eigen::SparseMatrix<double> lower(rows, rows);
    lower.setFromTriplets(entries.begin(), entries.end());
    return lower;
}

/// Where the factor has entries, by elimination as it is written: rows below a column meet each other.
Entries eliminated(const Eigen::SparseMatrix<double>& lower, const std::vector<int>& order) {
    const auto size = order.size();
    const Eigen::MatrixXd dense = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
    Entries entries(size, std::vector<char>(size, 0));
    for (std::size_t row = 0; row < size; ++row)
        for (std::size_t column = 0; column <= row; ++column)
            entries[row][column] = dense(order[row], order[column]) != 0;
    for (std::size_t column = 0; column < size; ++column)
        for (std::size_t row = column + 1; row < size; ++row)
            for (std::size_t other = row; other < size; ++other)
                if (entries[row][column] && entries[other][column]) entries[other][row] = 1;
    return entries;
}

} // namespace

TEST(EliminationTree, IsThatOfTheEliminationAsItIsWritten) {
    for (int round = 0; round < roundsOf(20, 400); ++round) {
        SCOPED_TRACE(seedOf(round));
        const int rows = 1 + 3 * round % 60;
        const Eigen::SparseMatrix<double> lower = sparseLower(rows, seedOf(round));
        std::vector<int> order(static_cast<std::size_t>(rows));
        std::iota(order.begin(), order.end(), 0);
        std::shuffle(order.begin(), order.end(), std::mt19937(seedOf(round)));
        const auto tree = eliminationTree(RowGraph(lower), order);
        ASSERT_TRUE(tree);
        EXPECT_TRUE(std::is_permutation(tree->order.begin(), tree->order.end(), order.begin(), order.end()));
        const Entries entries = eliminated(lower, tree->order);
        int total = 0;
        for (std::size_t column = 0; column < order.size(); ++column) {
            int count = 0, parent = -1;
            for (std::size_t row = order.size(); row-- > column;)
                if (entries[row][column]) {
                    ++count;
                    if (row > column) parent = static_cast<int>(row);
                }
            EXPECT_EQ(tree->counts[column], count);
            EXPECT_EQ(tree->parents[column], parent);
            total += count;
        }
        // As many entries as in the order that was asked for.
        const Entries asked = eliminated(lower, order);
        for (const std::vector<char>& row : asked)
            total -= static_cast<int>(std::count(row.begin(), row.end(), 1));
        EXPECT_EQ(total, 0);
    }
}

TEST(EliminationTree, HasRowsBelowAnotherRightBeforeIt) {
    const Eigen::SparseMatrix<double> lower = sparseLower(80, 7);
    std::vector<int> order(80);
    std::iota(order.begin(), order.end(), 0);
    const auto tree = eliminationTree(RowGraph(lower), order);
    ASSERT_TRUE(tree);
    std::vector<int> rowsBelow(80, 1);
    for (int row = 0; row < 80; ++row) {
        const auto r = static_cast<std::size_t>(row);
        const int parent = tree->parents[r];
        if (parent < 0) continue;
        EXPECT_GT(parent, row);
        rowsBelow[static_cast<std::size_t>(parent)] += rowsBelow[r];
    }
    for (int row = 0; row < 80; ++row)
        for (int below = row - rowsBelow[static_cast<std::size_t>(row)] + 1; below < row; ++below)
            EXPECT_TRUE(tree->parents[static_cast<std::size_t>(below)] <= row &&
                        tree->parents[static_cast<std::size_t>(below)] > 0);
}

TEST(EliminationTree, IsNoneOfMoreEntriesThanAllowed) {
    const Eigen::SparseMatrix<double> lower = sparseLower(50, 2);
    std::vector<int> order(50);
    std::iota(order.begin(), order.end(), 0);
    const auto tree = eliminationTree(RowGraph(lower), order);
    const auto entries =
        static_cast<std::size_t>(std::accumulate(tree->counts.begin(), tree->counts.end(), 0));
    EXPECT_TRUE(eliminationTree(RowGraph(lower), order, entries));
    EXPECT_FALSE(eliminationTree(RowGraph(lower), order, entries - 1));
}
