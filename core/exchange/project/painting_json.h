#pragma once

#include "core/support/json_reader.h"
#include "core/texture/layers/brush_stroke.h"

namespace esm {

/// Numbers of a brush stroke's point: its place and the surface's normal.
constexpr std::size_t numbersPerBrushPoint = 6;

/// Strokes as `docs/project-file.md` describes them, without their points.
nlohmann::ordered_json toJson(const BrushStrokes& strokes);

/// The numbers of a stroke's points.
std::vector<double> pointNumbers(const BrushStroke& stroke);

/// Takes what the strokes say from the points, which go on at `next`. Its numbers are finite where the points
/// are, and no more is checked: `validate()` does.
BrushStrokes strokesFromJson(const JsonReader& reader, const std::vector<double>& points, std::size_t& next);

} // namespace esm
