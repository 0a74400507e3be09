#include "core/dynamics/elimination/dissection.h"

#include "core/dynamics/elimination/elimination_tree.h"
#include "core/dynamics/step_matrix.h"
#include "tests/support/lattice_block.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace esm;

namespace {

SpringSystem systemOf(const test::LatticeBlock& block) {
    SpringNetwork network;
    network.restPositions = block.nodes;
    for (const LatticeSpring& spring : block.springs)
        tissue::addSpring(network, spring.first, spring.second);
    return makeSpringSystem(tissue::model(std::move(network), {}));
}

RowGraph graphOf(const SpringSystem& system) {
    return RowGraph(laplacianMatrix(system, {1, 0.01, 0}, std::vector<char>(system.mass.size(), 0)));
}

double factorEntries(const RowGraph& graph, const std::vector<int>& order) {
    const auto tree = eliminationTree(graph, order);
    return std::accumulate(tree->counts.begin(), tree->counts.end(), 0.0);
}

/// Whether all rows are there once.
bool isOrder(const std::vector<int>& order, std::size_t rows) {
    std::vector<int> sorted = order, all(rows);
    std::sort(sorted.begin(), sorted.end());
    std::iota(all.begin(), all.end(), 0);
    return sorted == all;
}

} // namespace

TEST(Dissection, OfALatticeHasLittleFillIn) {
    for (const LatticeKind kind : {LatticeKind::Cubic, LatticeKind::BodyCentred, LatticeKind::Diamond}) {
        const SpringSystem system = systemOf(test::latticeBlock(kind, 13, true));
        const auto nodes = static_cast<double>(system.mass.size());
        ASSERT_GT(nodes, 1000);
        const RowGraph graph = graphOf(system);
        const std::vector<int> order = dissect(graph, system.network->restPositions);
        EXPECT_TRUE(isOrder(order, system.mass.size()));
        EXPECT_LT(factorEntries(graph, order), 14 * std::pow(nodes, 4.0 / 3)) << wordOf(kind);
    }
}

TEST(Dissection, OfASurfaceHasLittleFillIn) {
    for (const int levels : {3, 4, 5}) {
        const SpringSystem system = makeSpringSystem(tissue::fromMesh(tissue::sphereMesh(levels, 0.1), {}));
        const auto nodes = static_cast<double>(system.mass.size());
        const RowGraph graph = graphOf(system);
        const std::vector<int> order = dissect(graph, system.network->restPositions);
        EXPECT_LT(factorEntries(graph, order), 4 * nodes * std::log2(nodes)) << levels;
    }
}

TEST(Dissection, IsAnOrderWhereverTheRowsLie) {
    const SpringSystem system = systemOf(test::latticeBlock(LatticeKind::Cubic, 6, true));
    const RowGraph graph = graphOf(system);
    std::vector<Eigen::Vector3d> places = system.network->restPositions;
    const auto isOrderAt = [&] { return isOrder(dissect(graph, places), places.size()); };
    std::reverse(places.begin() + 50, places.end());
    EXPECT_TRUE(isOrderAt()) << "anywhere";
    for (Eigen::Vector3d& place : places)
        place.y() = place.z() = 0;
    EXPECT_TRUE(isOrderAt()) << "on a line";
    std::fill(places.begin(), places.end(), Eigen::Vector3d::Zero());
    EXPECT_TRUE(isOrderAt()) << "all in one place";
}

// A star and a complete graph: a separator of one row, and none but one half.
TEST(Dissection, IsAnOrderWhateverIsCoupled) {
    constexpr int rows = 100;
    std::vector<Eigen::Vector3d> places;
    std::vector<Eigen::Triplet<double>> star, complete;
    for (int row = 0; row < rows; ++row) {
        places.emplace_back(std::sin(row), std::cos(3 * row), std::sin(5 * row));
        if (row > 0) star.emplace_back(row, 0, 1);
        for (int column = 0; column < row; ++column)
            complete.emplace_back(row, column, 1);
    }
    for (const auto& entries : {star, complete}) {
        Eigen::SparseMatrix<double> lower(rows, rows);
        lower.setFromTriplets(entries.begin(), entries.end());
        EXPECT_TRUE(isOrder(dissect(RowGraph(lower), places), rows));
    }
}
