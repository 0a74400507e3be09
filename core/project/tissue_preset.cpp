#include "core/project/tissue_preset.h"

#include "core/support/joined.h"
#include "core/support/numbers.h"

namespace esm {

void layPreset(Region& region, const TissuePreset& preset) {
    if (!preset.system) return;
    region.system = preset.system;
    region.inputs = preset.inputs;
    region.held.springConstant.reset();
    region.held.viscosity.reset();
}

void tiePreset(Scene& scene, const TissuePreset& preset) {
    if (!preset.tethers.empty()) scene.tethers = preset.tethers;
}

bool isAsPublished(const Project& project, const Region* region, const TissuePreset& preset) {
    const bool isTied = preset.tethers.empty() || project.scene.tethers == preset.tethers;
    const bool isWhole = !region || !region->ellipsoid;
    if (!preset.system) return isWhole && isTied;
    if (!region || region->system != preset.system || region->inputs != preset.inputs) return false;
    if (region->held.springConstant || region->held.viscosity) return false;
    const bool weighsAlike = !preset.mass || (project.base.mass == *preset.mass && !region->held.mass);
    return !isWhole || (isTied && weighsAlike);
}

bool isMeasured(const TissuePreset& preset) {
    return preset.published.youngsModulus.has_value();
}

std::string publishedText(const TissuePreset& preset) {
    std::vector<std::string> parts;
    const auto& [springConstant, viscosity, youngsModulus, relaxationTime] = preset.published;
    if (youngsModulus) parts.push_back(roundedText(*youngsModulus / 1000) + " kPa");
    if (relaxationTime) parts.push_back(roundedText(*relaxationTime) + " s");
    if (springConstant) parts.push_back(roundedText(*springConstant) + " N/m");
    if (viscosity) parts.push_back(roundedText(*viscosity) + " N·s/m");
    if (preset.mass) parts.push_back(roundedText(*preset.mass) + " kg");
    for (const TetherRule& rule : preset.tethers)
        parts.push_back("a tether of " + roundedText(rule.springConstant) + " N/m and " +
                        roundedText(rule.viscosity) + " N·s/m at one node in " + std::to_string(rule.every));
    return joined(parts);
}

} // namespace esm
