#include "core/dynamics/stepping.h"

#include "core/support/numbers.h"

#include <cmath>

namespace esm {

std::vector<std::string> validate(const MeasuredStepping& measured) {
    std::vector<std::string> problems = validate(withStepping({}, measured.stepping));
    if (measured.stepping.integrator == Integrator::Auto)
        problems.emplace_back("auto is not a measured integrator: name the one it became");
    if (!std::isfinite(measured.error) || measured.error < 0)
        problems.emplace_back("the error must be a number, 0 or more");
    if (!isPositive(measured.wallPerSimulatedSecond))
        problems.emplace_back("the wall time per simulated second must be a number above zero");
    return problems;
}

SimulationSettings withStepping(SimulationSettings settings, const Stepping& stepping) {
    settings.integrator = stepping.integrator;
    settings.timeStep = stepping.timeStep;
    settings.precision = stepping.precision;
    return settings;
}

const char* precisionName(Precision precision) {
    return precision == Precision::Float ? "float" : "double";
}

std::optional<Precision> precisionFromName(const std::string& name) {
    for (const Precision precision : {Precision::Double, Precision::Float})
        if (name == precisionName(precision)) return precision;
    return std::nullopt;
}

} // namespace esm
