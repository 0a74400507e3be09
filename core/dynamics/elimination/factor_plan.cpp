#include "core/dynamics/elimination/factor_plan.h"

#include "core/dynamics/elimination/dissection.h"
#include "core/dynamics/elimination/elimination_tree.h"

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <utility>

namespace esm {

namespace {

/// Entries of a factor per row up to which an order by least degree is as good as any.
constexpr std::size_t fewEntries = 50;

/// What a block costs in each solve, in entries of its panel that take as long: each row has to be looked up,
/// and there is work that does not depend on its size. By measurement on nets and lattices.
double costOf(int width, int height) {
    constexpr double ofRow = 3, ofBlock = 20;
    return double(width) * height + ofRow * height + ofBlock;
}

// Columns become a block where each is the parent of the one before and has its entries in the same rows but
// for one. Such blocks are mostly narrow; a block is joined to the one after it, which is its parent, where
// the zeros that become part of the panel cost less than a block of its own (Ashcraft and Grimes 1989).
std::vector<int> blockEndsOf(const EliminationTree& tree) {
    struct Group {
        int begin, end, height;
    };
    std::vector<Group> groups;
    const auto at = [](const std::vector<int>& numbers, int place) {
        return numbers[static_cast<std::size_t>(place)];
    };
    for (int column = 0; column < std::ssize(tree.order); ++column) {
        Group group{column, column + 1, at(tree.counts, column)};
        while (!groups.empty() && at(tree.parents, groups.back().end - 1) == group.begin) {
            const Group& child = groups.back();
            const int width = child.end - child.begin, joined = width + group.height;
            const double apart = costOf(width, child.height) + costOf(group.end - group.begin, group.height);
            if (costOf(group.end - child.begin, joined) > apart) break;
            group = {child.begin, group.end, joined};
            groups.pop_back();
        }
        groups.push_back(group);
    }
    std::vector<int> ends;
    ends.reserve(groups.size());
    for (const Group& group : groups)
        ends.push_back(group.end);
    return ends;
}

std::vector<int> leastDegreeOrder(const Eigen::SparseMatrix<double>& lower) {
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), order);
    return {order.indices().begin(), order.indices().end()};
}

// An order by least degree (AMD) is hard to beat where tissue is thin: dissection leaves half as many entries
// again in livers' nets and more in those of tubes and vessels. Where it leaves many, tissue is thick or very
// large.
EliminationTree bestTree(const RowGraph& graph, const Eigen::SparseMatrix<double>& lower,
                         const std::vector<Eigen::Vector3d>& places) {
    if (auto tree = eliminationTree(graph, leastDegreeOrder(lower), fewEntries * graph.rowCount()))
        return std::move(*tree);
    return eliminationTree(graph, dissect(graph, places)).value();
}

class FactorPlanner {
public:
    FactorPlanner(const RowGraph& graph, const EliminationTree& tree)
        : m_graph(graph), m_order(tree.order), m_blockOf(graph.rowCount()), m_metBy(graph.rowCount(), -1) {
        m_plan.places.resize(graph.rowCount());
        for (std::size_t place = 0; place < m_order.size(); ++place)
            placeOf(m_order[place]) = static_cast<int>(place);
        int begin = 0;
        for (const int end : blockEndsOf(tree)) {
            const auto number = static_cast<int>(m_plan.blocks.size());
            std::fill(m_blockOf.begin() + begin, m_blockOf.begin() + end, number);
            m_plan.blocks.emplace_back().begin = std::exchange(begin, end);
            m_plan.blocks.back().end = end;
        }
        m_plan.links.resize(m_plan.blocks.size());
    }

    FactorPlan planned(const Eigen::SparseMatrix<double>& lower) {
        for (std::size_t number = 0; number < m_plan.blocks.size(); ++number)
            planBlock(static_cast<int>(number));
        findTargets(lower);
        return std::move(m_plan);
    }

private:
    int& placeOf(int row) { return m_plan.places[static_cast<std::size_t>(row)]; }
    BlockLinks& linksOf(int number) { return m_plan.links[static_cast<std::size_t>(number)]; }
    FactorBlock& blockAt(int number) { return m_plan.blocks[static_cast<std::size_t>(number)]; }

    void planBlock(int number);
    std::vector<int> placesWithin(const FactorBlock& block, std::span<const int> rows) const;
    void findTargets(const Eigen::SparseMatrix<double>& lower);

    const RowGraph& m_graph;
    const std::vector<int>& m_order;
    std::vector<int> m_blockOf; ///< per row of the factor
    std::vector<int> m_metBy;   ///< per row of the factor, the block that it was found below of last
    FactorPlan m_plan;
};

/// A block has entries in the rows that its own are coupled to, and where its children leave some.
void FactorPlanner::planBlock(int number) {
    FactorBlock& block = blockAt(number);
    block.firstBelow = m_plan.rowsBelow.size();
    const auto meet = [&](int row) {
        if (row >= block.end && std::exchange(m_metBy[static_cast<std::size_t>(row)], number) != number)
            m_plan.rowsBelow.push_back(row);
    };
    for (int column = block.begin; column < block.end; ++column)
        for (const int other : m_graph.coupledTo(m_order[static_cast<std::size_t>(column)]))
            meet(placeOf(other));
    for (const int child : linksOf(number).children)
        for (std::size_t i = 0; i < blockAt(child).belowCount; ++i)
            meet(m_plan.rowsBelow[blockAt(child).firstBelow + i]);
    std::sort(m_plan.rowsBelow.begin() + static_cast<std::ptrdiff_t>(block.firstBelow),
              m_plan.rowsBelow.end());
    block.belowCount = m_plan.rowsBelow.size() - block.firstBelow;
    for (const int child : linksOf(number).children)
        linksOf(child).placesInParent = placesWithin(block, m_plan.below(blockAt(child)));
    block.values = m_plan.valueCount;
    m_plan.valueCount += block.width() * block.height();
    m_plan.mostRows = std::max(m_plan.mostRows, block.height());
    if (block.belowCount > 0)
        linksOf(m_blockOf[static_cast<std::size_t>(m_plan.rowsBelow[block.firstBelow])])
            .children.push_back(number);
}

/// @param rows increasing, all of them the block's
std::vector<int> FactorPlanner::placesWithin(const FactorBlock& block, std::span<const int> rows) const {
    std::vector<int> places;
    places.reserve(rows.size());
    const std::span<const int> below = m_plan.below(block);
    auto next = below.begin();
    for (const int row : rows) {
        if (row >= block.end) next = std::lower_bound(next, below.end(), row);
        places.push_back(row < block.end ? row - block.begin
                                         : block.end - block.begin + static_cast<int>(next - below.begin()));
    }
    return places;
}

void FactorPlanner::findTargets(const Eigen::SparseMatrix<double>& lower) {
    m_plan.targets.reserve(static_cast<std::size_t>(lower.nonZeros()));
    for (int outer = 0; outer < lower.outerSize(); ++outer)
        for (Eigen::SparseMatrix<double>::InnerIterator it(lower, outer); it; ++it) {
            const auto [column, row] = std::minmax({placeOf(outer), placeOf(static_cast<int>(it.row()))});
            const FactorBlock& block = blockAt(m_blockOf[static_cast<std::size_t>(column)]);
            const auto place = static_cast<std::size_t>(placesWithin(block, {&row, 1}).front());
            m_plan.targets.push_back(block.values +
                                     static_cast<std::size_t>(column - block.begin) * block.height() + place);
        }
}

} // namespace

FactorPlan planFactor(const Eigen::SparseMatrix<double>& lower, const std::vector<Eigen::Vector3d>& places) {
    const RowGraph graph(lower);
    if (graph.rowCount() == 0) return {};
    const EliminationTree tree = bestTree(graph, lower, places);
    return FactorPlanner(graph, tree).planned(lower);
}

} // namespace esm
