#pragma once

#include "core/dynamics/loads.h"

#include <array>
#include <cstddef>

/// Loads as programs in other languages give them, who may have anything there. All throw InvalidModel, which
/// says what is wrong with which.
namespace esm {

/// A vector for one of the nodes. @param what "force"
Eigen::Vector3d givenVector(const char* what, std::int64_t node, const Eigen::Vector3d& vector,
                            std::size_t nodeCount);

Eigen::Vector3d givenGravity(const Eigen::Vector3d& gravity); ///< m/s²

/// All that lies within the radius of a segment along its own z.
struct GivenInstrument {
    double radius, length;             ///< m; length of the segment, 0: a sphere
    Eigen::Vector3d place;             ///< m, of the segment's middle
    std::array<double, 4> orientation; ///< quaternion w, x, y, z, of any length; all 0: not turned
};
/// @param number in the list that is given, from 0
PlacedCollider givenInstrument(std::size_t number, const GivenInstrument& instrument);

} // namespace esm
