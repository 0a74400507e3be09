#include "core/dynamics/spring_system.h"

#include "core/support/errors.h"

namespace esm {

namespace {

SecondPhase secondPhaseOf(const std::optional<SpringStiffening>& law, double springConstant) {
    if (!law) return {};
    return {law->strain, law->factor * springConstant};
}

} // namespace

SpringSystem makeSpringSystem(const TissueModel& model) {
    if (auto problems = validate(model); !problems.empty()) throw InvalidModel(std::move(problems));
    SpringSystem system;
    system.network = model.network;
    system.mass = model.mass;
    system.tethers = model.tethers;
    system.springs.reserve(model.network->springs.size());
    for (const Spring& spring : model.network->springs) {
        const double constant = springConstant(model, spring);
        system.springs.push_back({spring.first, spring.second, spring.restLength, constant,
                                  viscosity(model, spring), secondPhaseOf(model.stiffening, constant)});
    }
    system.fixed.assign(model.mass.size(), 0);
    for (std::uint32_t node : model.fixedNodes)
        system.fixed[node] = 1;
    return system;
}

} // namespace esm
