#pragma once

#include "core/model/integrators.h"
#include "core/model/scene.h"

#include <string>
#include <vector>

namespace esm {

/// What an integrator does otherwise than its name promises.
std::vector<std::string> integratorWarnings(const Scene& scene, Integrator integrator);

} // namespace esm
