#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <string>
#include <vector>

namespace esm {

/// A set as another program describes it, as a trapezoid.
struct ShapeReading {
    Trapezoid set;
    /// Full beyond its corner, so that it reaches to the end of its variable's range.
    bool opensLeft = false, opensRight = false;
    std::string warning; ///< what it was, where the trapezoid only comes near it
};

/// A shape by its name in any case ("Triangle", "TRAPE") with its numbers; "Discrete" takes points x y x y …
/// @throws InvalidModel where no trapezoid comes near it
ShapeReading readShape(const std::string& shape, const std::vector<double>& numbers);

} // namespace esm
