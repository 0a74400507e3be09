#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace esm {

/// Heights in profiles are whole numbers of this part of a pixel, rounded away from the group.
constexpr int profileUnits = 64;

/// How far a group and its half of the gap reach up and down, in columns of the page. y is down.
struct GroupProfile {
    std::vector<std::int32_t> top, bottom; ///< per column, from the upper end of the group's box
    std::int32_t height = 0;               ///< of the box
    std::int64_t above = 0; ///< between the box's upper end and the group, all columns together
};

using OutlineSide = std::array<Eigen::Vector2d, 2>;

/// @param outline of the group in its box, pixels; its lowest coordinates are `margin`, half the gap
/// @param columns as many as the box is wide
GroupProfile profileOf(const std::vector<OutlineSide>& outline, double margin, double columnWidth,
                       std::size_t columns);

/// How a group stands on the page; as it was unfolded when neither.
struct GroupStance {
    bool leftIsRight = false, topIsBottom = false;
};
constexpr std::array<GroupStance, 4> groupStances{
    {{false, false}, {true, false}, {false, true}, {true, true}}};

GroupProfile mirrored(GroupProfile profile, const GroupStance& stance);

} // namespace esm
