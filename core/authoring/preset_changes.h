#pragma once

#include "core/authoring/regions.h"

#include <string>
#include <vector>

namespace esm {

/// One thing that changes, in words with units.
struct PresetChange {
    std::string what, before, after;

    bool operator==(const PresetChange&) const = default;
};

/// What applyPreset() would change for a region, the base mass and the tethers too. Empty where all of it is
/// so already. @throws InvalidModel as evaluate() does
std::vector<PresetChange> presetChanges(const Project& project, RegionId region, const TissuePreset& preset);

} // namespace esm
