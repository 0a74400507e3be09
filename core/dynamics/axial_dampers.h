#pragma once

#include "core/dynamics/spring_system.h"

namespace esm {

/// What the lengths of springs change by within an implicit step: the rate of change at its end is
/// (length − former)/duration.
struct LengthChange {
    std::vector<double> former; ///< m, per spring
    double duration;            ///< s
};

inline double springLength(const SpringSystem::Element& spring, const Vectors& positions) {
    return (positions[spring.first] - positions[spring.second]).norm();
}

/// From one place of the tissue to the end of a step of implicit Euler.
inline LengthChange changeFrom(const SpringSystem& system, const Vectors& positions, double timeStep) {
    LengthChange change{{}, timeStep};
    for (const auto& spring : system.springs)
        change.former.push_back(springLength(spring, positions));
    return change;
}

/// By backward differences over this step and the one before, which started at `previous`.
inline LengthChange changeFrom(const SpringSystem& system, const Vectors& positions, const Vectors& previous,
                               double timeStep) {
    LengthChange change{{}, 2 * timeStep / 3};
    for (const auto& spring : system.springs)
        change.former.push_back((4 * springLength(spring, positions) - springLength(spring, previous)) / 3);
    return change;
}

/// The tissue during a step of viscosity along the springs' axes alone: beside each spring, in place of its
/// viscosity, a spring of constant d/duration that rests at the former length. Its force at the step's end
/// is d times the rate at which the spring's length changes, along the direction it then has.
inline SpringSystem withAxialDampers(const SpringSystem& system, const LengthChange& change) {
    SpringSystem damped = system;
    for (std::size_t i = 0; i < system.springs.size(); ++i) {
        const auto& spring = system.springs[i];
        damped.springs[i].viscosity = 0;
        if (spring.viscosity > 0)
            damped.springs.push_back(
                {spring.first, spring.second, change.former[i], spring.viscosity / change.duration, 0});
    }
    return damped;
}

} // namespace esm
