#include "app/editor/edits/edit_system.h"

#include "core/authoring/regions.h"
#include "core/support/errors.h"

#include <algorithm>

namespace esm {

namespace {

using Variables = std::vector<FuzzyVariable>;

Variables::const_iterator findVariable(const Variables& variables, const std::string& name) {
    return std::find_if(variables.begin(), variables.end(),
                        [&](const FuzzyVariable& variable) { return variable.name == name; });
}

bool isNamed(const Variables& variables, const std::string& name) {
    return findVariable(variables, name) != variables.end();
}

/// The name that an input goes on under: its own, else the new one that stands in its place. None where it is
/// gone.
std::optional<std::string> laterName(const Variables& before, const Variables& after,
                                     const std::string& name) {
    if (isNamed(after, name)) return name;
    const auto place = static_cast<std::size_t>(findVariable(before, name) - before.begin());
    if (before.size() != after.size() || place == before.size() || isNamed(before, after[place].name))
        return std::nullopt;
    return after[place].name;
}

NamedValues laterValues(const NamedValues& values, const Variables& before, const Variables& after) {
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

} // namespace

void editSystem(Project& project, RegionId region, const FuzzySystem& system) {
    if (const auto problems = validate(system); !problems.empty()) throw InvalidModel(problems);
    const auto before = partOf(project.regions, region).system;
    const auto after = std::make_shared<const FuzzySystem>(system);
    for (Region& other : project.regions) {
        if (!other.system || other.system != before) continue;
        other.inputs = laterValues(other.inputs, before->inputs, after->inputs);
        other.system = after;
    }
}

void setRange(Project& project, RegionId region, const VariablePlace& place, const NewRange& range) {
    const FuzzySystem& system = *partOf(project.regions, region).system;
    const FuzzyVariable before = variableAt(system, place);
    editSystem(project, region,
               withVariable(system, place, withRange(before, range.minimum, range.maximum, range.terms)));
    if (place.side == FuzzySide::Outputs || range.terms == TermsInRange::Stay) return;
    const double scale = (range.maximum - range.minimum) / (before.maximum - before.minimum);
    for (Region& other : project.regions) {
        if (other.system != partOf(project.regions, region).system) continue;
        for (auto& [name, value] : other.inputs)
            if (name == before.name) value = range.minimum + (value - before.minimum) * scale;
    }
}

std::shared_ptr<const FuzzySystem> selectedSystem(const Selection& selection) {
    const Region* region = selection.selectedRegion();
    return region ? region->system : nullptr;
}

void editSelectedSystem(Document& document, const Selection& selection, const QString& text,
                        const FuzzySystem& system, EditKind kind) {
    const RegionId region = *selection.region();
    document.edit(
        text, [&](Project& project) { editSystem(project, region, system); }, {kind, region}, region);
}

} // namespace esm
