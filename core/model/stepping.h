#pragma once

#include "core/model/integrators.h"

#include <optional>
#include <string>
#include <vector>

namespace esm {

/// Of the numbers that explicit integrators compute with; the others take double.
enum class Precision { Double, Float };

/// "double", "float"
const char* precisionName(Precision precision);
std::optional<Precision> precisionFromName(const std::string& name);

/// One way to step the tissue.
struct Stepping {
    Integrator integrator = Integrator::Auto;
    double timeStep = 0; ///< s
    Precision precision = Precision::Double;

    bool operator==(const Stepping&) const = default;
};

/// A way to step that was measured on a scene, with isotropic damping.
struct MeasuredStepping {
    Stepping stepping;
    double error = 0;                  ///< relative to the motion itself
    double wallPerSimulatedSecond = 0; ///< on the machine that measured
    std::string tissue = {};           ///< tissueDigest of what it was measured on; empty where nobody said

    bool operator==(const MeasuredStepping&) const = default;
};

/// Every problem. Empty when tissue can be stepped so.
std::vector<std::string> validate(const Stepping& stepping);
std::vector<std::string> validate(const MeasuredStepping& measured);

} // namespace esm
