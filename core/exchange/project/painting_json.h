#pragma once

#include "core/support/json_reader.h"
#include "core/texture/layers/brush_stroke.h"

namespace esm {

/// Numbers of a brush stroke's point: its place and the surface's normal.
constexpr std::size_t numbersPerBrushPoint = 6;
/// Of what is left of the brush there: shares of radius and strength.
constexpr std::size_t numbersPerBrushShares = 2;

/// Strokes as `docs/project-file.md` describes them, without their points.
nlohmann::ordered_json toJson(const BrushStrokes& strokes);

/// The numbers of a stroke's points, and of their shares.
std::vector<double> pointNumbers(const BrushStroke& stroke);
std::vector<double> shareNumbers(const BrushStroke& stroke);

/// What a file holds of all strokes beside their list, and where the next stroke goes on in it.
struct StrokeArrays {
    std::vector<double> points, shares;
    std::size_t nextPoint = 0, nextShare = 0;
};

/// Takes what the strokes say from the arrays. Its numbers are finite where those are, and no more is
/// checked: `validate()` does.
BrushStrokes strokesFromJson(const JsonReader& reader, StrokeArrays& arrays);

} // namespace esm
