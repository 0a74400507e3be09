#include "core/authoring/edit_system.h"

#include "core/authoring/systems.h"
#include "core/support/errors.h"

#include <algorithm>

namespace esm {

namespace {

using InputList = std::vector<FuzzyVariable>;

InputList::const_iterator findVariable(const InputList& variables, const std::string& name) {
    return std::find_if(variables.begin(), variables.end(),
                        [&](const FuzzyVariable& variable) { return variable.name == name; });
}

bool isNamed(const InputList& variables, const std::string& name) {
    return findVariable(variables, name) != variables.end();
}

/// The name that an input goes on under: its own, else the new one that stands in its place. None where it is
/// gone.
std::optional<std::string> laterName(const InputList& before, const InputList& after,
                                     const std::string& name) {
    if (isNamed(after, name)) return name;
    const auto place = static_cast<std::size_t>(findVariable(before, name) - before.begin());
    if (before.size() != after.size() || place == before.size() || isNamed(before, after[place].name))
        return std::nullopt;
    return after[place].name;
}

NamedValues laterValues(const NamedValues& values, const InputList& before, const InputList& after) {
    NamedValues later;
    std::vector<std::string> known;
    for (const FuzzyVariable& variable : before)
        if (const auto name = laterName(before, after, variable.name)) known.push_back(*name);
    for (const auto& [name, value] : values)
        if (const auto goesOn = laterName(before, after, name)) later.emplace_back(*goesOn, value);
    for (const FuzzyVariable& variable : after)
        if (std::find(known.begin(), known.end(), variable.name) == known.end())
            later.emplace_back(variable.name, (variable.minimum + variable.maximum) / 2);
    return later;
}

/// "susilap-g, own", or with the next number that is free.
std::string nameOfCopy(const Project& project, const std::string& name,
                       const std::vector<std::string>& takenNames) {
    const std::string stem = name.substr(0, name.find(", own")) + ", own";
    const auto isTaken = [&takenNames, systems = systemsOf(project)](const std::string& own) {
        return std::find(takenNames.begin(), takenNames.end(), own) != takenNames.end() ||
               std::any_of(systems.begin(), systems.end(),
                           [&](const SharedSystem& system) { return system->name == own; });
    };
    std::string own = stem;
    for (int number = 2; isTaken(own); ++number)
        own = stem + ' ' + std::to_string(number);
    return own;
}

/// Where it is the only user, there is nothing to copy.
bool makesCopy(const Project& project, const FuzzySystem& before, Reach reach) {
    return reach == Reach::CopyForOne && usersOf(project, before).size() > 1;
}

void exchange(Region& region, const SharedSystem& before, const SharedSystem& after) {
    region.inputs = laterValues(region.inputs, before->inputs, after->inputs);
    region.system = after;
}

} // namespace

void editSystem(Project& project, RegionId region, const FuzzySystem& system, const EditScope& scope) {
    if (const auto problems = validate(system); !problems.empty()) throw InvalidModel(problems);
    Region& edited = partOf(project.regions, region);
    const SharedSystem before = edited.system;
    if (*before == system) return;
    if (makesCopy(project, *before, scope.reach)) {
        FuzzySystem copy = system;
        copy.name = nameOfCopy(project, system.name, scope.takenNames);
        return exchange(edited, before, std::make_shared<const FuzzySystem>(std::move(copy)));
    }
    const auto after = std::make_shared<const FuzzySystem>(system);
    for (Region& other : project.regions)
        if (other.system == before) exchange(other, before, after);
}

void setRange(Project& project, RegionId region, const VariablePlace& place, const NewRange& range,
              const EditScope& scope) {
    const FuzzySystem& system = *partOf(project.regions, region).system;
    const FuzzyVariable before = variableAt(system, place);
    editSystem(project, region,
               withVariable(system, place, withRange(before, range.minimum, range.maximum, range.terms)),
               scope);
    if (place.side == FuzzySide::Outputs || range.terms == TermsInRange::Stay) return;
    const double scale = (range.maximum - range.minimum) / (before.maximum - before.minimum);
    for (Region& other : project.regions) {
        if (other.system != partOf(project.regions, region).system) continue;
        for (auto& [name, value] : other.inputs)
            if (name == before.name) value = range.minimum + (value - before.minimum) * scale;
    }
}

} // namespace esm
