#pragma once

#include "core/exchange/charts/drawing.h"

#include <filesystem>

namespace esm {

/// Whether the name ends in .svg or .png, in small or capital letters.
bool isChartFile(const std::filesystem::path& file);

/// Writes a chart in the format that the file's ending says. @throws FileError where it says none, or the
/// file cannot be written
void writeChart(const Drawing& chart, const std::filesystem::path& file);

} // namespace esm
