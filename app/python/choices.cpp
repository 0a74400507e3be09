#include "app/python/choices.h"

#include "core/support/errors.h"

namespace esm::python {

Integrator chosenIntegrator(const std::string& name) {
    if (const auto found = integratorFromName(name)) return *found;
    throw InvalidModel("there is no integrator \"" + name + "\"; take one of " + integratorNames());
}

Precision chosenPrecision(const std::string& name) {
    if (const auto found = fromWord<Precision>(name)) return *found;
    throw InvalidModel("precision is \"double\" or \"float\", not \"" + name + "\"");
}

Damping chosenDamping(const std::string& name) {
    if (name == "isotropic") return Damping::Isotropic;
    if (name == "axial") return Damping::Axial;
    throw InvalidModel("damping is \"isotropic\" or \"axial\", not \"" + name + "\"");
}

} // namespace esm::python
