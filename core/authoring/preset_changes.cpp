#include "core/authoring/preset_changes.h"

#include "core/project/tissue_beneath.h"
#include "core/support/joined.h"
#include "core/support/numbers.h"

#include <array>
#include <utility>

namespace esm {

namespace {

std::string amountText(double value, const char* unit) {
    return roundedText(value, 4) + " " + unit;
}

std::string tetherText(const std::vector<TetherRule>& tethers) {
    std::vector<std::string> rules;
    rules.reserve(tethers.size());
    for (const TetherRule& rule : tethers)
        rules.push_back((rule.every == 1 ? "each node" : "one node in " + std::to_string(rule.every)) + ", " +
                        roundedText(rule.springConstant, 4) + " N/m, " + roundedText(rule.viscosity, 4) +
                        " N·s/m");
    return rules.empty() ? "none" : joined(rules, "; ");
}

/// Takes what differs, in the order in which it is asked.
class Comparison {
public:
    explicit Comparison(double wallThickness) : m_wallThickness(wallThickness) {}

    void add(const std::string& what, const std::string& before, const std::string& after) {
        if (before != after) m_changes.push_back({what, before, after});
    }

    /// @param beneath what a parameter keeps that is not set
    void addRegion(const Region& before, const Region& after, const std::optional<TissueBeneath>& beneath) {
        add("fuzzy system", systemText(before), systemText(after));
        for (const auto& [name, value] : after.inputs)
            add(name, inputText(before, name), inputText(after, name));
        static constexpr std::array<const char*, 3> names{"spring constant", "viscosity", "region mass"};
        static constexpr std::array<const char*, 3> units{"N/m", "N·s/m", "kg"};
        const RegionTissue then = evaluate(before, m_wallThickness), now = evaluate(after, m_wallThickness);
        add("relaxation time", timeText(then), timeText(now));
        for (const Parameter parameter : everyParameter) {
            const auto place = static_cast<std::size_t>(parameter);
            // Which mass lies beneath may change as well, and is told by itself.
            const bool isKnown = beneath && parameter != Parameter::Mass;
            const std::string kept = isKnown ? inWords(*beneath, parameter) : "as beneath";
            const auto text = [&](const TissueValues& values) {
                const auto value = valueOf(values, parameter);
                return value ? amountText(*value, units[place]) : kept;
            };
            add(names[place], text(then.values), text(now.values));
        }
    }

    std::vector<PresetChange> take() { return std::move(m_changes); }

private:
    static std::string timeText(const RegionTissue& tissue) {
        const auto& time = tissue.relaxationTime;
        return time ? amountText(*time, "s") : "as beneath";
    }
    static std::string systemText(const Region& region) {
        return region.system ? region.system->name : "none";
    }
    static std::string inputText(const Region& region, const std::string& name) {
        const auto value = valueOf(region.inputs, name);
        return value ? roundedText(*value, 4) : "none";
    }

    double m_wallThickness; // m
    std::vector<PresetChange> m_changes;
};

/// The whole organ's region is made beneath all others.
std::optional<TissueBeneath> beneathTarget(const Project& project, const Region* target) {
    if (target) return tissueBeneath(project, *target);
    Project bare = project;
    bare.regions.clear();
    return tissueBeneath(bare, Region{});
}

} // namespace

/// By applying it to a copy: what is listed is what will happen, whatever the rules of applying are.
std::vector<PresetChange> presetChanges(const Project& project, RegionId region, const TissuePreset& preset) {
    Project after = project;
    const std::optional<RegionId> target = applyPreset(after, region, preset);
    Comparison comparison(project.base.wallThickness);
    if (target) {
        const Region* before = findPart(project.regions, *target);
        comparison.addRegion(before ? *before : Region{}, partOf(after.regions, *target),
                             beneathTarget(project, before));
    }
    comparison.add("base mass", amountText(project.base.mass, "kg"), amountText(after.base.mass, "kg"));
    comparison.add("tethers", tetherText(project.scene.tethers), tetherText(after.scene.tethers));
    return comparison.take();
}

} // namespace esm
