#include "core/authoring/import_unit.h"

namespace esm {

namespace {

/// From a gland or a stretch of vessel to the vessels of a whole trunk.
bool isUsualSize(double metres) {
    return metres >= 0.02 && metres <= 1;
}

} // namespace

bool isPlausibleSize(double metres) {
    return metres >= 0.001 && metres <= 3;
}

std::vector<FittingUnit> fittingUnits(double extent) {
    std::vector<FittingUnit> fitting;
    for (const auto& [unit, word] : wordsOf<LengthUnit>)
        if (isPlausibleSize(extent * metresPer(unit))) fitting.push_back({unit, extent * metresPer(unit)});
    return fitting;
}

/// Units are tried in the order in which files use them: scanners and segmentation give millimetres,
/// modelling programs metres.
LengthUnit recommendedUnit(double extent, std::string_view fileEnding) {
    if (fileEnding == "glb" || fileEnding == "gltf") return LengthUnit::Metre;
    for (const LengthUnit unit : {LengthUnit::Millimetre, LengthUnit::Metre, LengthUnit::Centimetre})
        if (isUsualSize(extent * metresPer(unit))) return unit;
    return LengthUnit::Millimetre;
}

} // namespace esm
