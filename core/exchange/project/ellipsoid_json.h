#pragma once

#include "core/exchange/fields_json.h"
#include "core/geometry/ellipsoid.h"

namespace esm {

/// The orientation as a quaternion w, x, y, z, which is exact.
nlohmann::ordered_json toJson(const Ellipsoid& ellipsoid);

/// The orientation as a quaternion, or as people write it: "axis" and "degrees". Without either it is not
/// turned.
void fromJson(const JsonReader& reader, Ellipsoid& ellipsoid);

} // namespace esm
