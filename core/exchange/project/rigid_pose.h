#pragma once

#include "core/geometry/pose.h"
#include "core/support/json_reader.h"

namespace esm {

/// A pose of 16 numbers, row by row, as projector and camera files hold it: a turn and a shift. Poses that
/// were typed, or saved with few digits, are turned to the nearest rotation; one that is a rotation but for
/// rounding stays bit by bit. What mirrors, scales or shears is a problem and reads as no turn at all.
void fromJson(const JsonReader& reader, Pose& pose);
nlohmann::ordered_json toJson(const Pose& pose);

} // namespace esm
