#pragma once

#include <cstddef>

// What is compiled for each instruction set: see core/dynamics/kernel/slice_kernel.h. It includes no library.
namespace esm::kernel {

/// Lower trapezoid, column after column; what lies above the diagonal is not read.
struct Panel {
    const double* values;
    std::size_t width, height; ///< columns; rows
};

/// Three right-hand sides, x, y and z, in a panel's rows.
struct PanelSides {
    double* axes[3];
};

using PanelFunction = void (*)(const Panel& panel, const PanelSides& sides);

struct PanelFunctions {
    /// Solves the triangle for its rows and takes from those below what they lose by that.
    PanelFunction solveLower;
    /// Solves the transposed triangle for its rows, with those below known.
    PanelFunction solveUpper;
};

namespace v2 {
extern const PanelFunctions panelFunctions;
}

namespace v3 {
extern const PanelFunctions panelFunctions;
}

} // namespace esm::kernel
