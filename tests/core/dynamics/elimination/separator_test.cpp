#include "core/dynamics/elimination/separator.h"

#include "tests/support/rounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>

using namespace esm;

namespace {

using Couplings = std::vector<std::pair<int, int>>;

RowGraph graphOf(int rows, const Couplings& couplings) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int row = 0; row < rows; ++row)
        entries.emplace_back(row, row, 1);
    for (const auto& [one, other] : couplings)
        entries.emplace_back(std::max(one, other), std::min(one, other), 1);
    Eigen::SparseMatrix<double> lower(rows, rows);
    lower.setFromTriplets(entries.begin(), entries.end());
    return RowGraph(lower);
}

/// The fewest rows that have an end of each coupling, all sets of rows tried.
int fewestByTrial(int rows, const Couplings& couplings) {
    int fewest = rows;
    for (unsigned set = 0; set < 1U << rows; ++set) {
        const bool coversAll = std::all_of(couplings.begin(), couplings.end(), [&](const auto& coupling) {
            return (set >> coupling.first & 1) != 0 || (set >> coupling.second & 1) != 0;
        });
        if (coversAll) fewest = std::min(fewest, std::popcount(set));
    }
    return fewest;
}

} // namespace

TEST(SeparatorSearch, FindsTheFewestRowsThatPartTheSides) {
    constexpr int perSide = 6;
    for (int round = 0; round < roundsOf(60, 1000); ++round) {
        SCOPED_TRACE(seedOf(round));
        std::mt19937 random(seedOf(round));
        Couplings across;
        const std::size_t count = random() % 14;
        while (across.size() < count)
            across.emplace_back(static_cast<int>(random() % perSide),
                                perSide + static_cast<int>(random() % perSide));
        Couplings all = across;
        all.insert(all.end(), {{0, 1}, {perSide, perSide + 1}}); // within the sides, of no account
        const RowGraph graph = graphOf(2 * perSide, all);
        std::vector<Side> sides(2 * perSide, Side::First);
        std::fill(sides.begin() + perSide, sides.end(), Side::Second);

        const std::vector<int> separator = SeparatorSearch(graph).between({0, 1, 2, 3, 4, 5}, sides);
        EXPECT_EQ(static_cast<int>(separator.size()), fewestByTrial(2 * perSide, across));
        const auto contains = [&](int row) {
            return std::find(separator.begin(), separator.end(), row) != separator.end();
        };
        for (const auto& [one, other] : across)
            EXPECT_TRUE(contains(one) || contains(other)) << one << " " << other;
    }
}

TEST(SeparatorSearch, LooksAtTheTwoSidesAlone) {
    const RowGraph graph = graphOf(3, {{0, 1}, {0, 2}});
    SeparatorSearch search(graph);
    EXPECT_TRUE(search.between({0}, {Side::First, Side::Neither, Side::Neither}).empty());
    EXPECT_EQ(search.between({0}, {Side::First, Side::Neither, Side::Second}).size(), 1U);
}
