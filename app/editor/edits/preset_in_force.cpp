#include "app/editor/edits/preset_in_force.h"

#include "core/exchange/project/tissue_preset_file.h"

#include <algorithm>

namespace esm {

std::optional<TissuePreset> presetInForce(const Project& project, const Region* region) {
    static const std::vector<TissuePreset> presets = [] {
        std::vector<TissuePreset> all;
        for (const std::string& name : tissuePresetNames())
            all.push_back(tissuePreset(name));
        std::stable_partition(all.begin(), all.end(),
                              [](const TissuePreset& p) { return p.system != nullptr; });
        return all;
    }();
    const auto found = std::find_if(presets.begin(), presets.end(), [&](const TissuePreset& preset) {
        return isAsPublished(project, region, preset);
    });
    return found == presets.end() ? std::nullopt : std::optional(*found);
}

std::optional<TissuePreset> presetInForceAt(const Project& project, const Eigen::Vector3d& point) {
    constexpr double most = 0.5; // of the tissue there
    const auto top = std::find_if(project.regions.rbegin(), project.regions.rend(),
                                  [&](const Region& region) { return weightAt(region, point) > most; });
    return top == project.regions.rend() ? std::nullopt : presetInForce(project, &*top);
}

} // namespace esm
