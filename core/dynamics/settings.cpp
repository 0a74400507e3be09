#include "core/dynamics/settings.h"

#include "core/support/numbers.h"

namespace esm {

std::vector<std::string> validate(const SimulationSettings& settings) {
    constexpr double anyStep = 1; // s, in place of one that is chosen later and is sound
    std::vector<std::string> problems =
        validate(Stepping{settings.integrator, settings.timeStep.value_or(anyStep), settings.precision});
    const std::string integrator = integratorName(settings.integrator);
    if (!isAmount(settings.restTolerance))
        problems.emplace_back("the rest tolerance must be a number of metres, zero or more");
    if (settings.damping == Damping::Axial && !traitsOf(settings.integrator).mayDampAxially)
        problems.push_back(
            integrator +
            " needs isotropic damping: choose isotropic damping or another integrator, as implicit");
    if (settings.restTolerance > 0 && !mayBeExplicit(settings.integrator))
        problems.push_back(integrator +
                           " computes all of the tissue at once: leave the rest tolerance out, or choose an "
                           "explicit integrator, as euler");
    return problems;
}

SimulationSettings withStepping(SimulationSettings settings, const Stepping& stepping) {
    settings.integrator = stepping.integrator;
    settings.timeStep = stepping.timeStep;
    settings.precision = stepping.precision;
    return settings;
}

} // namespace esm
