#include "core/dynamics/settings.h"

#include "core/support/numbers.h"

namespace esm {

std::vector<std::string> validate(const SimulationSettings& settings) {
    std::vector<std::string> problems;
    if (settings.timeStep && !isPositive(*settings.timeStep))
        problems.emplace_back("the time step must be a number of seconds above zero");
    if (!isAmount(settings.restTolerance))
        problems.emplace_back("the rest tolerance must be a number of metres, zero or more");
    if (hasConstantMatrix(settings.integrator) && settings.damping == Damping::Axial)
        problems.push_back(
            std::string(integratorName(settings.integrator)) +
            " needs isotropic damping: choose isotropic damping or another integrator, as implicit");
    const bool mayBeExplicit = settings.integrator == Integrator::Auto || isExplicit(settings.integrator);
    if (settings.restTolerance > 0 && !mayBeExplicit)
        problems.push_back(std::string(integratorName(settings.integrator)) +
                           " computes all of the tissue at once: leave the rest tolerance out, or choose an "
                           "explicit integrator, as euler");
    if (settings.precision == Precision::Float && !mayBeExplicit)
        problems.push_back(
            std::string(integratorName(settings.integrator)) +
            " computes in double precision: choose double or an explicit integrator, as euler");
    return problems;
}

} // namespace esm
