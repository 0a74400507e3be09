#pragma once

#include "core/exchange/charts/drawing.h"

#include <optional>

namespace esm {

/// A line across a chart at an x, and what it means.
struct DrawnMark {
    double x;
    std::string text; ///< ASCII
};

/// What a curve is called, and where it goes, in the units of the axes.
struct DrawnCurve {
    std::string name; ///< of which letters beyond ASCII are not shown, and no more than 20
    std::vector<Drawing::Place> points;
    std::optional<DrawnMark> mark;
};

/// What stands at the two axes, with the unit: "depth, mm".
struct CurveAxes {
    std::string x, y;
};

/// A line for each curve over axes from 0 on. Points that stand apart have dots.
Drawing curveDrawing(const CurveAxes& axes, const std::vector<DrawnCurve>& curves);

} // namespace esm
