#include "core/dynamics/settings.h"

#include "core/support/numbers.h"

#include <array>

namespace esm {

namespace {

constexpr std::array<const char*, 4> integratorNames{"auto", "euler", "split", "split2"};

} // namespace

const char* integratorName(Integrator integrator) {
    return integratorNames.at(static_cast<std::size_t>(integrator));
}

std::optional<Integrator> integratorFromName(const std::string& name) {
    for (std::size_t i = 0; i < integratorNames.size(); ++i)
        if (name == integratorNames.at(i)) return static_cast<Integrator>(i);
    return std::nullopt;
}

std::vector<std::string> validate(const SimulationSettings& settings) {
    std::vector<std::string> problems;
    if (settings.timeStep && !isPositive(*settings.timeStep))
        problems.emplace_back("the time step must be a number of seconds above zero");
    const bool split = settings.integrator == Integrator::Split || settings.integrator == Integrator::Split2;
    if (split && settings.damping == Damping::Axial)
        problems.push_back(std::string(integratorName(settings.integrator)) +
                           " needs isotropic damping: choose isotropic damping or the integrator euler");
    return problems;
}

} // namespace esm
