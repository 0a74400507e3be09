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

/// What lies within a margin of sides is convex: in a column its extremes are at the column's borders or at
/// the sides' ends.
class Extents {
public:
    Extents(double margin, double columnWidth, std::size_t columns)
        : m_margin(margin), m_columnWidth(columnWidth), m_columns(columns) {}

    void include(const OutlineSide& side) {
        for (const Eigen::Vector2d& end : side)
            m_columns[columnAt(end.x())].include(end.y() - m_margin, end.y() + m_margin);
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
