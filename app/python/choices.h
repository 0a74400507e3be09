#pragma once

#include "core/dynamics/settings.h"

#include <string>

/// What Python names by words. @throws InvalidModel, which says the words there are
namespace esm::python {

Integrator chosenIntegrator(const std::string& name);
Precision chosenPrecision(const std::string& name);
Damping chosenDamping(const std::string& name);

} // namespace esm::python
