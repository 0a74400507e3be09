#pragma once

#include <optional>
#include <string>
#include <vector>

namespace esm {

/// How time is stepped. `Auto` becomes one of the others when a simulation is made.
enum class Integrator { Auto, Euler, Split, Split2 };

/// The command line's name: auto, euler, split, split2.
const char* integratorName(Integrator integrator);
std::optional<Integrator> integratorFromName(const std::string& name);

enum class Damping { Isotropic, Axial };

struct SimulationSettings {
    Integrator integrator = Integrator::Auto;
    std::optional<double> timeStep;       ///< s; chosen safely without
    Damping damping = Damping::Isotropic; ///< split and split2 refuse axial
};

/// Every problem of the settings. Empty when they can be used.
std::vector<std::string> validate(const SimulationSettings& settings);

} // namespace esm
