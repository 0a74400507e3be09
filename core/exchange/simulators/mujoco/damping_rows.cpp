#include "core/exchange/simulators/mujoco/damping_rows.h"

#include "core/geometry/disjoint_sets.h"
#include "core/support/errors.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace esm {

namespace {

using DampingMatrix = Eigen::SparseMatrix<double>;
using DampingFactors = Eigen::SimplicialLDLT<DampingMatrix>;

constexpr std::uint32_t noRow = std::numeric_limits<std::uint32_t>::max();

/// Which nodes the factors are of. A part that nothing holds may move as a whole undamped, and its matrix has
/// no factors; its first node, the anchor, is left out of them. Its row is what makes every column's sum 0.
struct DampedNodes {
    std::vector<std::uint32_t> rows;  ///< by node, or `noRow`
    std::vector<std::uint32_t> nodes; ///< by row
    std::vector<std::uint32_t>
        anchors; ///< by row, the anchor of its part, or `noRow` where something holds it
};

DampedNodes dampedNodes(const SpringSystem& system, const std::vector<char>& still) {
    const std::size_t count = system.mass.size();
    DisjointSets parts(count); // that viscous springs hold together
    std::vector<char> isDamped(count, 0), isHeld(count, 0);
    for (const auto& spring : system.springs)
        if (spring.viscosity > 0 && !still[spring.first] && !still[spring.second])
            parts.join(spring.first, spring.second);
    for (const auto& spring : system.springs) {
        if (!(spring.viscosity > 0)) continue;
        for (const auto& [node, other] :
             {std::pair(spring.first, spring.second), std::pair(spring.second, spring.first)}) {
            if (still[node]) continue;
            isDamped[node] = 1;
            if (still[other]) isHeld[parts.lowest(node)] = 1;
        }
    }
    DampedNodes damped{std::vector<std::uint32_t>(count, noRow), {}, {}};
    for (std::uint32_t node = 0; node < count; ++node) {
        const std::uint32_t first = parts.lowest(node);
        if (!isDamped[node] || (node == first && !isHeld[first])) continue;
        damped.rows[node] = static_cast<std::uint32_t>(damped.nodes.size());
        damped.nodes.push_back(node);
        damped.anchors.push_back(isHeld[first] ? noRow : first);
    }
    return damped;
}

DampingMatrix dampingMatrix(const SpringSystem& system, const DampedNodes& damped) {
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](std::uint32_t node, std::uint32_t other, double value) {
        const std::uint32_t row = damped.rows[node], column = damped.rows[other];
        if (row != noRow && column != noRow)
            entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
    };
    for (const auto& spring : system.springs) {
        if (!(spring.viscosity > 0)) continue;
        add(spring.first, spring.first, spring.viscosity);
        add(spring.second, spring.second, spring.viscosity);
        add(spring.first, spring.second, -spring.viscosity);
        add(spring.second, spring.first, -spring.viscosity);
    }
    const auto size = static_cast<Eigen::Index>(damped.nodes.size());
    DampingMatrix matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

/// @param column of L, unsorted: nodes and coefficients
DampingRow dampingRowOf(double viscosity, std::vector<std::pair<std::uint32_t, double>> column,
                        std::uint32_t anchor) {
    // What is left of sums that are 0, as at an anchor that is far away.
    constexpr double rounding = 1e-14;
    double sum = 0;
    for (const auto& [node, coefficient] : column)
        sum += coefficient;
    if (anchor != noRow && std::abs(sum) > rounding) column.emplace_back(anchor, -sum);
    std::sort(column.begin(), column.end());
    DampingRow row{viscosity, {}, {}};
    for (const auto& [node, coefficient] : column) {
        row.nodes.push_back(node);
        row.coefficients.push_back(coefficient);
    }
    return row;
}

} // namespace

std::vector<DampingRow> dampingRows(const SpringSystem& system, const std::vector<char>& still) {
    const DampedNodes damped = dampedNodes(system, still);
    if (damped.nodes.empty()) return {};
    const DampingFactors factors(dampingMatrix(system, damped));
    if (factors.info() != Eigen::Success || !(factors.vectorD().minCoeff() > 0))
        throw InvalidModel("viscosities of springs differ by too much to be written as tendons: raise the "
                           "smallest ones, or hand it over with axial damping");
    const auto& order = factors.permutationPinv().indices();
    const auto nodeAt = [&](Eigen::Index place) {
        return damped.nodes[static_cast<std::size_t>(order[place])];
    };
    const DampingMatrix lower = factors.matrixL().nestedExpression();
    std::vector<DampingRow> rows;
    for (Eigen::Index place = 0; place < lower.cols(); ++place) {
        std::vector<std::pair<std::uint32_t, double>> column{{nodeAt(place), 1.0}};
        for (DampingMatrix::InnerIterator entry(lower, place); entry; ++entry)
            if (entry.row() > place && entry.value() != 0)
                column.emplace_back(nodeAt(entry.row()), entry.value());
        rows.push_back(dampingRowOf(factors.vectorD()[place], std::move(column),
                                    damped.anchors[static_cast<std::size_t>(order[place])]));
    }
    return rows;
}

} // namespace esm
