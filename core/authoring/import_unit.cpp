#include "core/authoring/import_unit.h"

#include <algorithm>
#include <array>
#include <optional>

namespace esm {

namespace {

/// From a gland or a stretch of vessel to the vessels of a whole trunk.
bool isUsualSize(double metres) {
    return metres >= 0.02 && metres <= 1;
}

/// In the order in which files use them: scanners and segmentation give millimetres, modelling programs
/// metres.
constexpr std::array usualUnits{LengthUnit::Millimetre, LengthUnit::Metre, LengthUnit::Centimetre};

/// The first that gives such a size.
std::optional<LengthUnit> unitFor(bool (*isFitting)(double metres), double extent) {
    const auto fits = [&](LengthUnit unit) { return isFitting(extent * metresPer(unit)); };
    const auto found = std::find_if(usualUnits.begin(), usualUnits.end(), fits);
    return found == usualUnits.end() ? std::nullopt : std::optional(*found);
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

/// glTF is in metres by its standard, but not every program that writes it knows.
LengthUnit recommendedUnit(double extent, std::string_view fileEnding) {
    const bool isInMetres = fileEnding == "glb" || fileEnding == "gltf";
    if (isInMetres && isPlausibleSize(extent)) return LengthUnit::Metre;
    if (const auto usual = unitFor(isUsualSize, extent)) return *usual;
    const LengthUnit otherwise = isInMetres ? LengthUnit::Metre : LengthUnit::Millimetre;
    return unitFor(isPlausibleSize, extent).value_or(otherwise);
}

} // namespace esm
