#include "core/dynamics/schemes/axial_dampers.h"

namespace esm {

namespace {

double lengthOf(const SpringSystem::Element& spring, const Vectors& positions) {
    return (positions[spring.first] - positions[spring.second]).norm();
}

} // namespace

// Viscosity along a spring's axis depends on the direction that the spring has at the end of the step, which
// is not known yet. A matrix D with the old directions would let a spring that turns grow longer against no
// resistance. Written as a spring that wants its former length back, the damper turns with the tissue: its
// force is the gradient of d/(2·duration)·(length − former)², so that it fits into the potential that
// Newton's steps go down.
LengthChange changeFrom(const SpringSystem& system, const Vectors& positions, double timeStep) {
    LengthChange change{{}, timeStep};
    change.former.reserve(system.springs.size());
    for (const auto& spring : system.springs)
        change.former.push_back(lengthOf(spring, positions));
    return change;
}

LengthChange changeFrom(const SpringSystem& system, const Vectors& positions, const Vectors& previous,
                        double timeStep) {
    // The rate (3l⁺ − 4l + l⁻)/(2h), written as (l⁺ − former)/duration.
    LengthChange change{{}, 2 * timeStep / 3};
    change.former.reserve(system.springs.size());
    for (const auto& spring : system.springs)
        change.former.push_back((4 * lengthOf(spring, positions) - lengthOf(spring, previous)) / 3);
    return change;
}

SpringSystem withAxialDampers(const SpringSystem& system, const LengthChange& change) {
    SpringSystem damped = system;
    damped.springs.reserve(2 * system.springs.size());
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
