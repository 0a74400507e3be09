#pragma once

#include "core/model/spring_network.h"

namespace esm {

constexpr std::size_t motionModelNodes = 8;

/// The nodes of motionModel() that can move, and those that are fixed in space.
constexpr Edge motionModelLine{0, 1};
constexpr std::array<std::uint32_t, 6> motionModelFixed{2, 3, 4, 5, 6, 7};

/// A stiff organ is not deformed but pushed as a whole; a handful of springs inside it gives its motion
/// [R 5.1, fig. 5.4]. Two inner nodes on the organ's length; each hangs on three fixed outer nodes which
/// stand around it like a tripod, so that it is held in every direction: 8 nodes, 7 springs. The organ's
/// origin is the middle of the line between the inner nodes, its orientation that line's.
/// @param length from one end of the organ to the other, m; not zero
SpringNetwork motionModel(const Eigen::Vector3d& centre, const Eigen::Vector3d& length);

/// The same inside a surface, along the direction in which it is longest; it carries the surface rigidly.
SpringNetwork motionModelOf(const TriangleMesh& mesh);

} // namespace esm
