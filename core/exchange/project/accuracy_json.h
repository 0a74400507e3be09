#pragma once

#include "core/project/measured_accuracy.h"
#include "core/support/json_reader.h"

namespace esm {

nlohmann::ordered_json toJson(const MeasuredAccuracy& accuracy);
/// Runs of integrators that only other programs know are left out.
MeasuredAccuracy accuracyFromJson(const JsonReader& reader);
/// Says how many were left out. Precondition: accuracyFromJson() found no problem in `json`.
std::vector<std::string> accuracyWarnings(const nlohmann::ordered_json& json, const MeasuredAccuracy& read);

} // namespace esm
