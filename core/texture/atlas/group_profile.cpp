#include "core/texture/atlas/group_profile.h"

#include "core/texture/atlas/reach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace esm {

namespace {

/// Up and down to where a column is full.
struct Extent {
    double top = std::numeric_limits<double>::infinity(), bottom = -top;

    void include(double low, double high) {
        top = std::min(top, low);
        bottom = std::max(bottom, high);
    }
};

/// A group is packed by its outline and not by its box, so that others reach into its dents. For each column
/// of the page the profile keeps the least and the greatest height that the group, grown by half the gap on
/// all sides, has anywhere in that column. It never says less than there is: two groups whose profiles do not
/// overlap keep the whole gap, whatever their shapes between the borders of columns.
///
/// What lies within a margin of one side is a stadium and convex. Its topmost and lowest points in a column
/// are therefore on the column's borders or straight above and below the side's ends; nothing else is looked
/// at.
class Extents {
public:
    Extents(double margin, double columnWidth, std::size_t columns)
        : m_margin(margin), m_columnWidth(columnWidth), m_columns(columns) {}

    void include(const OutlineSide& side) {
        for (const Eigen::Vector2d& end : side)
            m_columns[columnAt(end.x())].include(end.y() - m_margin, end.y() + m_margin);
        // The reach of points along a row is asked with x and y exchanged: it then goes along columns.
        const Eigen::Vector2d a(side[0].y(), side[0].x()), b(side[1].y(), side[1].x());
        const auto [low, high] = std::minmax(side[0].x(), side[1].x());
        const std::size_t last = columnAt(high + m_margin);
        for (std::size_t column = columnAt(low - m_margin) + 1; column <= last; ++column) {
            const double x = static_cast<double>(column) * m_columnWidth;
            const double top = leftReach(a, b, x, m_margin), bottom = rightReach(a, b, x, m_margin);
            m_columns[column - 1].include(top, bottom);
            m_columns[column].include(top, bottom);
        }
    }

    const std::vector<Extent>& columns() const { return m_columns; }

private:
    std::size_t columnAt(double x) const {
        return std::min(static_cast<std::size_t>(std::max(0.0, x / m_columnWidth)), m_columns.size() - 1);
    }

    double m_margin, m_columnWidth; ///< pixels
    std::vector<Extent> m_columns;
};

std::int64_t sumOf(const std::vector<std::int32_t>& heights) {
    return std::accumulate(heights.begin(), heights.end(), std::int64_t{0});
}

} // namespace

/// Heights become whole numbers, top down and bottom up, away from the group. Sums over columns are then
/// exact, and the packing the same whatever order they are added in; the price is at most a 64th of a pixel
/// on each side.
GroupProfile profileOf(const std::vector<OutlineSide>& outline, double margin, double columnWidth,
                       std::size_t columns) {
    Extents extents(margin, columnWidth, columns);
    double height = 0;
    for (const OutlineSide& side : outline) {
        extents.include(side);
        height = std::max({height, side[0].y() + margin, side[1].y() + margin});
    }
    GroupProfile profile;
    profile.height = static_cast<std::int32_t>(std::ceil(profileUnits * height));
    profile.top.reserve(columns);
    profile.bottom.reserve(columns);
    for (const Extent& extent : extents.columns()) {
        const bool isEmpty = extent.top > extent.bottom; // the box is a little wider than the group
        const double top = isEmpty ? height / 2 : std::max(0.0, extent.top);
        const double bottom = isEmpty ? height / 2 : extent.bottom;
        profile.top.push_back(static_cast<std::int32_t>(std::floor(profileUnits * top)));
        profile.bottom.push_back(
            std::min(profile.height, static_cast<std::int32_t>(std::ceil(profileUnits * bottom))));
    }
    profile.above = sumOf(profile.top);
    return profile;
}

GroupProfile mirrored(GroupProfile profile, const GroupStance& stance) {
    if (stance.leftIsRight) {
        std::reverse(profile.top.begin(), profile.top.end());
        std::reverse(profile.bottom.begin(), profile.bottom.end());
    }
    if (stance.topIsBottom) {
        std::swap(profile.top, profile.bottom);
        for (std::vector<std::int32_t>* border : {&profile.top, &profile.bottom})
            for (std::int32_t& y : *border)
                y = profile.height - y;
        profile.above = sumOf(profile.top);
    }
    return profile;
}

} // namespace esm
