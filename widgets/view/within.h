#pragma once

#include "widgets/view/sight.h"

namespace esm {

/// A wide view from inside the organ, the way the camera looks or along a much longer one: the eye stands in
/// the middle of the longest room between two walls along a line of sight. Rooms with walls on all sides come
/// first. None where the line does not meet two walls.
/// @param about a point that the line goes through, m; the middle of the picture without
std::optional<Camera> cameraWithin(const Sight& sight, const std::optional<Eigen::Vector3d>& about);

} // namespace esm
