#include "app/esmc/integrator_warnings.h"

#include "core/dynamics/stability/swings.h"

namespace esm {

std::vector<std::string> integratorWarnings(const Scene& scene, Integrator integrator) {
    std::vector<std::string> warnings;
    if (integrator == Integrator::AdamsMoulton && !scene.moves.empty())
        warnings.emplace_back("while a node is led adams-moulton steps as rk4 does: what it gives is rk4's");
    if (lagsWhereTissueTurns(integrator))
        warnings.push_back(std::string(integratorName(integrator)) +
                           " lags behind where tissue turns, unless its steps are very short: implicit and "
                           "bdf2 follow it");
    return warnings;
}

} // namespace esm
