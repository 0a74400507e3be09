#pragma once

#include "core/dynamics/settings.h"

namespace esm {

/// One way to step the tissue.
struct Stepping {
    Integrator integrator = Integrator::Auto;
    double timeStep = 0; ///< s
    Precision precision = Precision::Double;
};

/// A way to step that was measured on a scene, with isotropic damping.
struct MeasuredStepping {
    Stepping stepping;
    double error = 0;                  ///< relative to the motion itself
    double wallPerSimulatedSecond = 0; ///< on the machine that measured
};

/// Every problem. Empty when tissue can be stepped so.
std::vector<std::string> validate(const MeasuredStepping& measured);

/// These settings with the integrator, step and precision of `stepping`.
SimulationSettings withStepping(SimulationSettings settings, const Stepping& stepping);

/// "double", "float"
const char* precisionName(Precision precision);
std::optional<Precision> precisionFromName(const std::string& name);

} // namespace esm
