#include "core/authoring/systems.h"

#include <algorithm>

namespace esm {

namespace {

bool isAmong(const std::vector<SharedSystem>& systems, const SharedSystem& system) {
    return std::any_of(systems.begin(), systems.end(),
                       [&](const SharedSystem& other) { return sameValue(other, system); });
}

bool isUsed(const Project& project, const SharedSystem& system) {
    return std::any_of(project.regions.begin(), project.regions.end(),
                       [&](const Region& region) { return region.system == system; });
}

/// Under `before`, if it had such an input.
std::optional<double> keptValue(const FuzzyVariable& input, const FuzzySystem& before,
                                const NamedValues& values) {
    const bool wasThere =
        std::any_of(before.inputs.begin(), before.inputs.end(), [&](const FuzzyVariable& other) {
            return other.name == input.name && other.unit == input.unit;
        });
    const auto value = wasThere ? valueOf(values, input.name) : std::nullopt;
    return value && *value >= input.minimum && *value <= input.maximum ? value : std::nullopt;
}

} // namespace

std::vector<SharedSystem> systemsOf(const Project& project) {
    std::vector<SharedSystem> systems;
    const auto add = [&](const SharedSystem& system) {
        if (system && !isAmong(systems, system)) systems.push_back(system);
    };
    for (const Region& region : project.regions)
        add(region.system);
    for (const SharedSystem& spare : project.spareSystems)
        add(spare);
    return systems;
}

std::vector<const Region*> usersOf(const Project& project, const FuzzySystem& system) {
    std::vector<const Region*> users;
    for (const Region& region : project.regions)
        if (region.system && (region.system.get() == &system || *region.system == system))
            users.push_back(&region);
    return users;
}

void keepSystem(Project& project, const SharedSystem& former) {
    auto& spare = project.spareSystems;
    if (former && std::find(spare.begin(), spare.end(), former) == spare.end()) spare.emplace_back(former);
    std::erase_if(spare, [&](const SharedSystem& system) { return isUsed(project, system); });
}

void removeSpareSystem(Project& project, const FuzzySystem& system) {
    std::erase_if(project.spareSystems, [&](const SharedSystem& spare) { return *spare == system; });
}

NamedValues inputsUnder(const FuzzySystem& system, const FuzzySystem& before, const NamedValues& values) {
    if (system.inputs == before.inputs) return values; // one that was left out stays so
    NamedValues inputs;
    for (const FuzzyVariable& input : system.inputs)
        inputs.emplace_back(input.name,
                            keptValue(input, before, values).value_or(input.minimum / 2 + input.maximum / 2));
    return inputs;
}

} // namespace esm
