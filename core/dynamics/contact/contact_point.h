#pragma once

#include "core/dynamics/contact/contact.h"

namespace esm {

/// m, of a contact's point.
inline Eigen::Vector3d pointOf(const Contact& contact, const Vectors& positions) {
    Eigen::Vector3d point = contact.arm;
    for (const auto& [node, weight] : contact.shares)
        point += weight * positions[node];
    return point;
}

} // namespace esm
