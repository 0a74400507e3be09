#include "app/esmc/integrator_warnings.h"

namespace esm {

std::vector<std::string> integratorWarnings(const Scene& scene, Integrator integrator) {
    std::vector<std::string> warnings;
    const IntegratorTraits& traits = traitsOf(integrator);
    const std::string name = traits.name, first = integratorName(traits.startsAs);
    // Explicit ones begin anew in every step that leads nodes.
    if (isExplicit(integrator) && traits.startsAs != integrator && !scene.moves.empty())
        warnings.push_back("while a node is led " + name + " steps as " + first + " does: what it gives is " +
                           first + "'s");
    if (traits.lagsWhereTissueTurns)
        warnings.push_back(name +
                           " lags behind where tissue turns, unless its steps are very short: implicit and "
                           "bdf2 follow it");
    return warnings;
}

} // namespace esm
