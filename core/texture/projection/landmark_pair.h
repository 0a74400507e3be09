#pragma once

#include "core/support/fields.h"

#include <Eigen/Core>

namespace esm {

/// The same landmark in a photo and on an organ.
struct LandmarkPair {
    Eigen::Vector2d photo = Eigen::Vector2d::Zero(); ///< pixels from the top left corner
    Eigen::Vector3d organ = Eigen::Vector3d::Zero(); ///< m

    bool operator==(const LandmarkPair&) const = default;
};
template<>
inline constexpr auto fieldsOf<LandmarkPair> = fieldTable(field("photo", &LandmarkPair::photo),
                                                          field("organ", &LandmarkPair::organ));

} // namespace esm
