#pragma once

#include "core/exchange/simulators/model_tables.h"

#include <string>

namespace esm {

/// The table as text for spreadsheets and scripts: a line of headings with units ("rest_length_m"), then a
/// line for each row, in UTF-8. Values are parted by commas; decimals have a point and read back the same.
/// @throws Cancelled
std::string csvOf(const ModelTable& table, const Progress& progress = {});

} // namespace esm
