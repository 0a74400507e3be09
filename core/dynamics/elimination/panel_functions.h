#pragma once

#include "core/dynamics/elimination/panel_kernel.h"

// The kernel, for the instruction set that the including source is compiled for. In an unnamed namespace:
// nothing of it may be seen by other sources. Vectors have four lanes on every processor and nothing is
// fused, so that results are the same on all.
namespace esm::kernel {
namespace {

constexpr std::size_t laneCount = 4;
using Lanes [[gnu::vector_size(8 * laneCount), gnu::aligned(8), gnu::may_alias]] = double;

/// Columns that are taken at once: what is read of the sides then serves as many.
constexpr std::size_t columnGroup = 4;

/// Some columns of a panel from their diagonal on, and the sides' rows from there on.
struct PanelPart {
    const double* values;
    std::size_t stride, rows;
    double* axes[3];

    PanelPart(const Panel& panel, const PanelSides& sides, std::size_t column)
        : values(panel.values + column * (panel.height + 1)), stride(panel.height),
          rows(panel.height - column), axes{sides.axes[0] + column, sides.axes[1] + column,
                                            sides.axes[2] + column} {}

    double at(std::size_t row, std::size_t column) const { return values[column * stride + row]; }
    const Lanes& lanesAt(std::size_t row, std::size_t column) const {
        return *reinterpret_cast<const Lanes*>(values + column * stride + row);
    }
    Lanes& sideLanes(std::size_t axis, std::size_t row) const {
        return *reinterpret_cast<Lanes*>(axes[axis] + row);
    }
};

template<std::size_t columns> void solveLowerPart(const PanelPart& part) {
    double solved[3][columns];
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t k = 0; k < columns; ++k) {
            double value = part.axes[axis][k];
            for (std::size_t j = 0; j < k; ++j)
                value -= part.at(k, j) * solved[axis][j];
            part.axes[axis][k] = solved[axis][k] = value / part.at(k, k);
        }
    std::size_t row = columns;
    for (; row + laneCount <= part.rows; row += laneCount)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Lanes side = part.sideLanes(axis, row);
            for (std::size_t k = 0; k < columns; ++k)
                side -= part.lanesAt(row, k) * solved[axis][k];
            part.sideLanes(axis, row) = side;
        }
    for (; row < part.rows; ++row)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t k = 0; k < columns; ++k)
                part.axes[axis][row] -= part.at(row, k) * solved[axis][k];
}

template<std::size_t columns> void solveUpperPart(const PanelPart& part) {
    Lanes sums[3][columns] = {};
    std::size_t row = columns;
    for (; row + laneCount <= part.rows; row += laneCount)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Lanes side = part.sideLanes(axis, row);
            for (std::size_t k = 0; k < columns; ++k)
                sums[axis][k] += part.lanesAt(row, k) * side;
        }
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t k = columns; k-- > 0;) {
            const Lanes& sum = sums[axis][k];
            double value = part.axes[axis][k] - ((sum[0] + sum[1]) + (sum[2] + sum[3]));
            for (std::size_t rest = row; rest < part.rows; ++rest)
                value -= part.at(rest, k) * part.axes[axis][rest];
            for (std::size_t j = k + 1; j < columns; ++j)
                value -= part.at(j, k) * part.axes[axis][j];
            part.axes[axis][k] = value / part.at(k, k);
        }
}

void solveLowerPanel(const Panel& panel, const PanelSides& sides) {
    std::size_t column = 0;
    for (; column + columnGroup <= panel.width; column += columnGroup)
        solveLowerPart<columnGroup>({panel, sides, column});
    for (; column < panel.width; ++column)
        solveLowerPart<1>({panel, sides, column});
}

void solveUpperPanel(const Panel& panel, const PanelSides& sides) {
    const std::size_t grouped = panel.width / columnGroup * columnGroup;
    for (std::size_t column = panel.width; column-- > grouped;)
        solveUpperPart<1>({panel, sides, column});
    for (std::size_t column = grouped; column > 0;)
        solveUpperPart<columnGroup>({panel, sides, column -= columnGroup});
}

} // namespace
} // namespace esm::kernel
