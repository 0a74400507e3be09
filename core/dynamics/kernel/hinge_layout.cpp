#include "core/dynamics/kernel/hinge_layout.h"

#include "core/support/errors.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace esm {

namespace {

using kernel::sliceHeight;
using Numbers = std::vector<std::uint32_t>;
using Rows = std::array<std::uint32_t, 4>;

std::vector<Rows> rowsOfHinges(const SpringSystem& system, const SliceLayout& slices) {
    std::vector<Rows> rows;
    rows.reserve(system.hinges.size());
    for (const auto& hinge : system.hinges) {
        Rows& corners = rows.emplace_back();
        for (std::size_t i = 0; i < corners.size(); ++i)
            corners[i] = slices.rowOfNode[hinge.nodes[i]];
    }
    return rows;
}

/// By the rows of their nodes: hinges of a block are then near each other, and sums do not depend on the
/// order of the model's list.
Numbers sortedByRows(const std::vector<Rows>& rows) {
    Numbers order(rows.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return rows[a] < rows[b]; });
    return order;
}

/// Of every row, the places of the forces on it.
std::vector<Numbers> placesByRow(const std::vector<Rows>& rows, const Numbers& order, std::size_t rowCount) {
    std::vector<Numbers> places(rowCount);
    for (std::uint32_t i = 0; i < order.size(); ++i)
        for (std::uint32_t corner = 0; corner < 4; ++corner)
            places[rows[order[i]][corner]].push_back(4 * i + corner);
    return places;
}

void placeForces(const std::vector<Numbers>& byRow, HingeLayout& layout) {
    kernel::ForcePlaces none;
    std::fill_n(none.of, sliceHeight, static_cast<std::uint32_t>(layout.forceCount() - 1));
    layout.starts = {0};
    for (std::size_t begin = 0; begin < byRow.size(); begin += sliceHeight) {
        const std::uint32_t start = layout.starts.back();
        for (std::size_t row = begin; row < begin + sliceHeight; ++row)
            for (std::size_t i = 0; i < byRow[row].size(); ++i) {
                if (layout.places.size() == start + i) layout.places.push_back(none);
                layout.places[start + i].of[row % sliceHeight] = byRow[row][i];
            }
        layout.starts.push_back(static_cast<std::uint32_t>(layout.places.size()));
    }
}

} // namespace

HingeLayout makeHingeLayout(const SpringSystem& system, const SliceLayout& slices, std::size_t recordSize) {
    if (system.hinges.empty()) return {};
    if (system.hinges.size() > std::numeric_limits<std::uint32_t>::max() / 4 - 2 * sliceHeight)
        throw InvalidModel("the model has more hinges than can be simulated");
    const std::vector<Rows> rows = rowsOfHinges(system, slices);
    HingeLayout layout;
    layout.order = sortedByRows(rows);
    layout.nodes.resize((rows.size() + sliceHeight - 1) / sliceHeight);
    for (std::uint32_t i = 0; i < layout.order.size(); ++i) {
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const std::uint32_t row = rows[layout.order[i]][corner];
            layout.nodes[i / sliceHeight].offset[corner][i % sliceHeight] =
                static_cast<std::uint32_t>(row * recordSize);
        }
    }
    placeForces(placesByRow(rows, layout.order, slices.rowCount()), layout);
    return layout;
}

} // namespace esm
