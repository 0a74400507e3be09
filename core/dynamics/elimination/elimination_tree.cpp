#include "core/dynamics/elimination/elimination_tree.h"

#include <utility>

namespace esm {

namespace {

int& at(std::vector<int>& numbers, int place) {
    return numbers[static_cast<std::size_t>(place)];
}
int at(const std::vector<int>& numbers, int place) {
    return numbers[static_cast<std::size_t>(place)];
}

std::vector<int> inverse(const std::vector<int>& order) {
    std::vector<int> places(order.size());
    for (std::size_t place = 0; place < order.size(); ++place)
        at(places, order[place]) = static_cast<int>(place);
    return places;
}

// Each row hangs everything it meets below it on itself (Liu 1986). Ways that were gone once are cut short,
// so that the next one takes no time.
std::vector<int> parentsOf(const RowGraph& graph, const std::vector<int>& order) {
    const std::vector<int> places = inverse(order);
    std::vector<int> parents(order.size(), -1), shortCuts(order.size(), -1);
    for (int row = 0; row < std::ssize(order); ++row)
        for (const int other : graph.coupledTo(at(order, row)))
            for (int below = at(places, other); below >= 0 && below < row;) {
                const int next = std::exchange(at(shortCuts, below), row);
                if (next < 0) at(parents, below) = row;
                below = next;
            }
    return parents;
}

/// Rows so that those below each in the tree come right before it.
std::vector<int> postorder(const std::vector<int>& parents) {
    std::vector<int> firstChild(parents.size(), -1), nextSibling(parents.size(), -1), roots, result;
    for (int row = static_cast<int>(parents.size()); row-- > 0;) {
        const int parent = at(parents, row);
        if (parent < 0)
            roots.push_back(row);
        else
            at(nextSibling, row) = std::exchange(at(firstChild, parent), row);
    }
    result.reserve(parents.size());
    std::vector<int> way;
    while (!roots.empty() || !way.empty()) {
        if (way.empty()) {
            way.push_back(roots.back());
            roots.pop_back();
        }
        const int child = at(firstChild, way.back());
        if (child >= 0) {
            at(firstChild, way.back()) = at(nextSibling, child);
            way.push_back(child);
        } else {
            result.push_back(way.back());
            way.pop_back();
        }
    }
    return result;
}

/// A row has entries in all columns on the ways up to it from those that it is coupled to.
bool countEntries(const RowGraph& graph, EliminationTree& tree, std::size_t mostEntries) {
    const std::vector<int> places = inverse(tree.order);
    std::vector<int> metBy(tree.order.size(), -1);
    tree.counts.assign(tree.order.size(), 1);
    std::size_t entries = tree.order.size();
    for (int row = 0; row < std::ssize(tree.order); ++row) {
        at(metBy, row) = row;
        for (const int other : graph.coupledTo(at(tree.order, row)))
            for (int column = at(places, other); column < row && at(metBy, column) != row;
                 column = at(tree.parents, column)) {
                at(metBy, column) = row;
                ++at(tree.counts, column);
                ++entries;
            }
        if (entries > mostEntries) return false;
    }
    return true;
}

} // namespace

std::optional<EliminationTree> eliminationTree(const RowGraph& graph, const std::vector<int>& order,
                                               std::size_t mostEntries) {
    const std::vector<int> parents = parentsOf(graph, order), visited = postorder(parents);
    const std::vector<int> places = inverse(visited);
    EliminationTree tree;
    for (const int row : visited) {
        tree.order.push_back(at(order, row));
        tree.parents.push_back(at(parents, row) < 0 ? -1 : at(places, at(parents, row)));
    }
    if (!countEntries(graph, tree, mostEntries)) return std::nullopt;
    return tree;
}

} // namespace esm
