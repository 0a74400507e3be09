#include "core/exchange/project/model_json.h"

#include <algorithm>

namespace esm {

namespace {

bool joinsByAndAlone(const FuzzyCondition& condition) {
    using Kind = FuzzyCondition::Kind;
    return condition.kind == Kind::Is ||
           (condition.kind == Kind::And &&
            std::all_of(condition.parts.begin(), condition.parts.end(),
                        [](const FuzzyCondition& part) { return part.kind == Kind::Is; }));
}

} // namespace

bool needsExtendedInference(const FuzzySystem& system) {
    return !(system.norms == FuzzyNorms{}) ||
           std::any_of(system.rules.begin(), system.rules.end(), [](const FuzzyRule& rule) {
               return rule.weight != 1 || !joinsByAndAlone(rule.condition);
           });
}

bool needsClinicalUnits(const FuzzySystem& system) {
    for (std::size_t output = 0; output < system.outputs.size(); ++output)
        if (isInClinicalUnits(system, output)) return true;
    return false;
}

VersionNeeds needsOf(const std::vector<Region>& regions, const BaseTissue& base, bool binding) {
    const auto any = [&](auto&& is) { return std::any_of(regions.begin(), regions.end(), is); };
    VersionNeeds needs;
    needs.binding = binding;
    needs.stiffening = base.stiffening.has_value();
    needs.bending = base.resistsBending;
    needs.extendedInference =
        any([](const Region& region) { return region.system && needsExtendedInference(*region.system); });
    needs.softRims = any([](const Region& region) { return region.rim != 0; });
    needs.clinicalUnits = base.wallThickness != usualWallThickness || any([](const Region& region) {
                              return region.system && needsClinicalUnits(*region.system);
                          });
    return needs;
}

int versionOf(const VersionNeeds& needs) {
    if (needs.sheet || needs.clinicalUnits || needs.bending || needs.fluids || needs.prisms || needs.graded)
        return 13;
    if (needs.lattice) return 12;
    if (needs.finish || needs.retouching || needs.stretchedLayout) return 11;
    if (needs.shapedMasks) return 10;
    if (needs.instruments || needs.splits || needs.wideBinding) return 9;
    if (needs.painting || needs.landmarks || needs.maskedPhotos) return 8;
    if (needs.preparation) return 7;
    if (needs.perspective) return 6;
    if (needs.softRims) return 5;
    if (needs.extendedInference) return 4;
    if (needs.stiffening) return 3;
    return needs.binding ? 2 : 1;
}

} // namespace esm
