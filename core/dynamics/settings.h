#pragma once

#include "core/model/stepping.h"

#include <functional>
#include <vector>

namespace esm {

/// What of two nodes' relative velocity a spring damps: all of it, or the part along the spring.
enum class Damping { Isotropic, Axial };

struct SimulationSettings {
    Integrator integrator = Integrator::Auto;
    std::optional<double> timeStep;       ///< s; chosen safely without
    Damping damping = Damping::Isotropic; ///< some integrators refuse axial
    Precision precision = Precision::Double;
    /// m; explicit integrators leave out what rests until motion reaches it, so that the trajectory stays
    /// within this of the whole tissue's. 0: nothing is left out.
    double restTolerance = 0;
    std::size_t threads = 0; ///< at most; 0: as many as the tissue's size is worth
    /// Asked now and then within a step that takes long; where it says no, the step ends with Cancelled.
    std::function<bool()> isWanted = {};
};

/// What steps the tissue: an integrator other than `Auto`, and a step.
struct ChosenStep {
    Integrator integrator;
    double timeStep; ///< s
};

/// Every problem of the settings. Empty when they can be used.
std::vector<std::string> validate(const SimulationSettings& settings);

/// These settings with the integrator, step and precision of `stepping`.
SimulationSettings withStepping(SimulationSettings settings, const Stepping& stepping);

} // namespace esm
