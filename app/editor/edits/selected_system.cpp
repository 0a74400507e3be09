#include "app/editor/edits/selected_system.h"

#include "core/exchange/fuzzy/fuzzy_file.h"

namespace esm {

std::shared_ptr<const FuzzySystem> selectedSystem(const Selection& selection) {
    const Region* region = selection.selectedRegion();
    return region ? region->system : nullptr;
}

EditScope scopeOf(Reach reach) {
    return {reach, fuzzyPresetNames()};
}

void editSelectedSystem(Document& document, const Selection& selection, const FuzzySystem& system,
                        const SystemStep& step) {
    const RegionId region = *selection.region();
    document.edit(
        step.text, [&](Project& project) { editSystem(project, region, system, scopeOf(step.reach)); },
        {step.kind, region}, region);
}

} // namespace esm
