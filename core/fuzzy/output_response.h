#pragma once

#include "core/fuzzy/fuzzy_system.h"
#include "core/support/progress.h"

#include <optional>
#include <utility>
#include <vector>

namespace esm {

/// How one output of a system answers to its inputs.
struct ResponseQuestion {
    std::size_t output = 0;
    std::vector<std::optional<double>> inputs; ///< as of infer(); what is varied need not be there
};

struct ResponsePoint {
    double input, output;
};
/// Unbroken pieces from left to right. Between two of them no rule reaches the output, or it jumps.
using ResponseCurve = std::vector<std::vector<ResponsePoint>>;

/// The output over one input's range, the others held: at even steps, at the corners of the input's terms and
/// just beside them, and ever closer where it is steep or ends, so that neighbouring points differ by at most
/// a hundredth of the output's range and gaps begin where they do to 2 · 10⁻⁹ of the input's range. Where
/// 6000 points are not enough for that, the rest is at the even steps and the corners alone and breaks at
/// corners only. Preconditions as of infer(). @throws Cancelled
ResponseCurve responseCurve(const FuzzySystem& system, const ResponseQuestion& question, std::size_t input,
                            const Progress& progress = {});

/// The output over two inputs, in cells of even size. Rows go up with the second input.
struct ResponseMap {
    std::size_t cells = 0;                     ///< along either input
    std::vector<std::optional<double>> values; ///< of the cells' middles, row by row

    const std::optional<double>& at(std::size_t column, std::size_t row) const {
        return values[row * cells + column];
    }
};

/// The two inputs of a map.
struct MapInputs {
    std::size_t across = 0, up = 1;
};

/// Preconditions as of infer(); two different inputs. @throws Cancelled
ResponseMap responseMap(const FuzzySystem& system, const ResponseQuestion& question, const MapInputs& inputs,
                        std::size_t cells, const Progress& progress = {});

/// Between which values an output lies where its rules conclude one term at a time, whatever their degrees:
/// the scale for its curves and maps. The whole range where no rule concludes anything of it.
std::pair<double, double> usualValues(const FuzzySystem& system, std::size_t output);

} // namespace esm
