#pragma once

#include "core/geometry/ellipsoid.h"
#include "core/support/json_reader.h"

namespace esm {

nlohmann::ordered_json vectorToJson(const Eigen::Vector3d& vector);

/// The orientation as a quaternion w, x, y, z, which is exact.
nlohmann::ordered_json toJson(const Ellipsoid& ellipsoid);

/// The orientation as a quaternion, or as people write it: "axis" and "degrees". Without either it is not
/// turned.
Ellipsoid ellipsoidFromJson(const JsonReader& reader);

} // namespace esm
