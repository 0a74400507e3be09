#pragma once

#include "core/dynamics/spring_system.h"

namespace esm {

/// What the lengths of springs change by within an implicit step: the rate of change at its end is
/// (length − former)/duration.
struct LengthChange {
    std::vector<double> former; ///< m, per spring
    double duration;            ///< s
};

/// From one place of the tissue to the end of a step of implicit Euler.
LengthChange changeFrom(const SpringSystem& system, const Vectors& positions, double timeStep);

/// By backward differences over this step and the one before, which started at `previous`.
LengthChange changeFrom(const SpringSystem& system, const Vectors& positions, const Vectors& previous,
                        double timeStep);

/// The tissue during a step of viscosity along the springs' axes alone: beside each spring, in place of its
/// viscosity, a spring of constant d/duration that rests at the former length. Its force at the step's end
/// is d times the rate at which the spring's length changes, along the direction it then has.
SpringSystem withAxialDampers(const SpringSystem& system, const LengthChange& change);

} // namespace esm
