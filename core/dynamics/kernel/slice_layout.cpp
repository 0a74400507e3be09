#include "core/dynamics/kernel/slice_layout.h"

#include "core/dynamics/kernel/node_order.h"
#include "core/support/errors.h"

#include <algorithm>
#include <limits>

namespace esm {

namespace {

using kernel::sliceHeight;
using Numbers = std::vector<std::uint32_t>;

Numbers springsPerNode(const SpringSystem& system) {
    Numbers count(system.mass.size(), 0);
    for (const auto& spring : system.springs) {
        ++count[spring.first];
        ++count[spring.second];
    }
    return count;
}

/// Sorts by the number of springs within stretches of the order (SELL-C-σ of Kreutzer et al. 2014, with C = 8
/// and σ = 128). A slice is as wide as its longest row, so that rows of like length in a slice leave little
/// of it empty. To sort all nodes would leave less still, but tear neighbours apart; within a stretch they
/// stay near.
void evenOut(Numbers& order, const Numbers& springCounts) {
    constexpr std::size_t stretch = 16 * sliceHeight;
    const auto hasMore = [&](std::uint32_t a, std::uint32_t b) { return springCounts[a] > springCounts[b]; };
    for (std::size_t begin = 0; begin < order.size(); begin += stretch) {
        const std::size_t end = std::min(begin + stretch, order.size());
        std::stable_sort(order.begin() + static_cast<std::ptrdiff_t>(begin),
                         order.begin() + static_cast<std::ptrdiff_t>(end), hasMore);
    }
}

Numbers columnStarts(const Numbers& order, const Numbers& springCounts) {
    Numbers starts{0};
    for (std::size_t begin = 0; begin < order.size(); begin += sliceHeight) {
        std::uint32_t columns = 0;
        for (std::size_t i = begin; i < std::min(begin + sliceHeight, order.size()); ++i)
            columns = std::max(columns, springCounts[order[i]]);
        starts.push_back(starts.back() + columns);
    }
    return starts;
}

// Places in a row that no spring fills point back at the row's own node, with all parameters 0: the kernel
// computes them as springs of no length and no force, and needs no branch for the ends of rows.
LargeVector<kernel::Neighbours> ownNeighbours(const Numbers& starts, std::size_t recordSize) {
    LargeVector<kernel::Neighbours> neighbours(starts.back());
    for (std::size_t slice = 0; slice + 1 < starts.size(); ++slice)
        for (std::size_t column = starts[slice]; column < starts[slice + 1]; ++column)
            for (std::size_t i = 0; i < sliceHeight; ++i)
                neighbours[column].offset[i] =
                    static_cast<std::uint32_t>((slice * sliceHeight + i) * recordSize);
    return neighbours;
}

/// Springs in the order of the lower of their rows, then of the higher: every row then meets its neighbours
/// in the order of theirs. The order in which a node's forces are added up hangs on the rows alone, and not
/// on the order of the model's list of springs.
Numbers springsByRows(const SpringSystem& system, const Numbers& rowOfNode) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> sorted;
    sorted.reserve(system.springs.size());
    for (const auto& spring : system.springs) {
        const auto [low, high] = std::minmax(rowOfNode[spring.first], rowOfNode[spring.second]);
        sorted.emplace_back(std::uint64_t{low} << 32 | high, static_cast<std::uint32_t>(sorted.size()));
    }
    std::sort(sorted.begin(), sorted.end());
    Numbers springs;
    springs.reserve(sorted.size());
    for (const auto& [rows, spring] : sorted)
        springs.push_back(spring);
    return springs;
}

void placeSprings(const SpringSystem& system, std::size_t recordSize, SliceLayout& layout) {
    Numbers filled(layout.rowCount(), 0);
    const auto place = [&](std::uint32_t node, std::uint32_t neighbour) {
        const std::uint32_t row = layout.rowOfNode[node];
        const std::uint32_t column = layout.starts[row / sliceHeight] + filled[row]++;
        layout.neighbours[column].offset[row % sliceHeight] =
            static_cast<std::uint32_t>(layout.rowOfNode[neighbour] * recordSize);
        return static_cast<std::uint32_t>(column * sliceHeight + row % sliceHeight);
    };
    layout.entries.resize(system.springs.size());
    for (const std::uint32_t i : springsByRows(system, layout.rowOfNode)) {
        const auto& spring = system.springs[i];
        layout.entries[i].first = place(spring.first, spring.second);
        layout.entries[i].second = place(spring.second, spring.first);
    }
}

} // namespace

SliceLayout makeSliceLayout(const SpringSystem& system, std::size_t recordSize) {
    if (system.mass.size() > std::numeric_limits<std::uint32_t>::max() / recordSize - sliceHeight)
        throw InvalidModel("the model has more nodes than can be simulated");
    const Numbers springCounts = springsPerNode(system);
    Numbers order = reverseCuthillMcKee(system);
    evenOut(order, springCounts);

    SliceLayout layout;
    layout.rowOfNode.resize(order.size());
    for (std::size_t row = 0; row < order.size(); ++row)
        layout.rowOfNode[order[row]] = static_cast<std::uint32_t>(row);
    layout.starts = columnStarts(order, springCounts);
    layout.neighbours = ownNeighbours(layout.starts, recordSize);
    placeSprings(system, recordSize, layout);
    return layout;
}

} // namespace esm
