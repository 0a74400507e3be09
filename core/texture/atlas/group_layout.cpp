#include "core/texture/atlas/group_layout.h"

#include "core/support/parallel_steps.h"
#include "core/texture/atlas/planar_hull.h"
#include "core/texture/atlas/waiting_patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace esm {

namespace {

/// Of the tallest that wait and are not too tall for the page, how many are looked at for a place.
constexpr std::size_t mostComparedGroups = 64;

/// Columns of a mean group. More follow its outline better; the time to compare a place grows with them.
/// Below half a pixel a column would tell apart what texels do not.
constexpr double columnsPerGroup = 24;
constexpr double narrowestColumn = 0.5; ///< pixels

/// Tenths of its length by which a group may begin before the end of the last one: ends are slanted, and a
/// group that overhangs its neighbour's slant leaves less room than one that begins behind it.
constexpr int mostTenthsBack = 3;

/// Part of a waiting group's height by which the bottom of a valley may rise and fall. With 0 each notch in a
/// ragged border would be a valley of its own that nothing fits into, and be closed.
constexpr double valleyDepth = 0.8;

/// By the coordinates of its ends: an order in which a side can be looked up.
bool comesBefore(const OutlineSide& a, const OutlineSide& b) {
    const auto numbers = [](const OutlineSide& side) {
        return std::array{side[0].x(), side[0].y(), side[1].x(), side[1].y()};
    };
    return numbers(a) < numbers(b);
}

/// What is inside a group cannot touch others, so only sides that one triangle alone has are profiled.
/// Triangles unfolded over a side share its ends bit by bit, and run along it in opposite directions: exact
/// comparison finds them.
std::vector<OutlineSide> outlineOf(const std::vector<PatchCorners>& triangles) {
    std::vector<OutlineSide> sides;
    sides.reserve(3 * triangles.size());
    for (const PatchCorners& corners : triangles)
        for (std::size_t i = 0; i < 3; ++i)
            sides.push_back({corners[i], corners[(i + 1) % 3]});
    std::vector<OutlineSide> sorted = sides;
    std::sort(sorted.begin(), sorted.end(), comesBefore);
    const auto isShared = [&](const OutlineSide& side) {
        return side[0] != side[1] &&
               std::binary_search(sorted.begin(), sorted.end(), OutlineSide{side[1], side[0]}, comesBefore);
    };
    sides.erase(std::remove_if(sides.begin(), sides.end(), isShared), sides.end());
    return sides;
}

/// Where a group may lie.
struct GroupPlace {
    std::uint32_t group = 0, link = 0;
    std::size_t stance = 0;
    std::size_t column = 0;
    std::int32_t y = 0; ///< profile units
};

/// The page is filled from its upper border. Of what is full only the lower border is kept, one number for
/// each column: the skyline. A group is pushed up against it until its own upper profile touches, as in
/// Tetris (Lévy, Petitjean, Ray and Maillot 2002, Least squares conformal maps for automatic texture atlas
/// generation). Room above a group that its profile shuts in is lost; that is the price of one number for
/// each column, and what the choice of group and stance keeps small.
///
/// Where the next one goes is decided as by Burke, Kendall and Whitwell (2004, A new placement heuristic for
/// the orthogonal stock-cutting problem): the lowest valley is filled first, by what fits it best, instead of
/// searching the best place for the next group in the list. The skyline stays level, and small groups wait
/// until a valley needs them.
class SkylinePacker {
public:
    /// @throws Cancelled
    SkylinePacker(const std::vector<TurnedGroup>& groups, double scale, const PageRoom& page, int mostPages,
                  const Progress& progress)
        : m_groups(groups), m_scale(scale), m_margin(page.gap / 2), m_page(page), m_mostPages(mostPages),
          m_columnWidth(columnWidth()), m_skyline(static_cast<std::size_t>(page.size / m_columnWidth), 0),
          m_profiles(groups.size()), m_waiting(groups.size()) {
        for (const TurnedGroup& group : groups) {
            m_firstTriangles.push_back(m_layout.corners.size());
            m_layout.corners.resize(m_layout.corners.size() + group.corners.size());
            m_area += group.area;
        }
        m_layout.page.resize(m_layout.corners.size());
        // A point has no area to set its waste against; without this it would never be worth a place.
        m_smallestArea = 1e-6 * m_area / static_cast<double>(groups.size());
        makeProfiles(progress);
    }

    /// @throws Cancelled
    PatchLayout pack(const Progress& progress) {
        while (!m_waiting.isEmpty()) {
            reportProgress(progress, m_area > 0 ? m_laidArea / m_area : 0);
            const Valley valley = lowestValley();
            if (const std::optional<GroupPlace> place = bestPlace(valley))
                lay(*place);
            else if (!moveOn(valley))
                return givenUp();
        }
        m_layout.pages = m_pageNumber + 1;
        m_layout.height = m_pageNumber * room() + static_cast<double>(m_lowest) / profileUnits - m_page.gap;
        return std::move(m_layout);
    }

private:
    /// For groups of the mean length; the same for all, since they share one skyline.
    double columnWidth() const {
        double lengths = 0;
        for (const TurnedGroup& group : m_groups)
            lengths += group.length;
        const double mean = m_scale * lengths / static_cast<double>(m_groups.size());
        return std::min(m_page.size, std::max(narrowestColumn, mean / columnsPerGroup));
    }
    std::int32_t pageHeight() const { return static_cast<std::int32_t>(profileUnits * m_page.size); }
    double room() const { return m_page.size - m_page.gap; }

    std::size_t columnsOf(const TurnedGroup& group) const {
        const double columns = (m_scale * group.length + m_page.gap) / m_columnWidth;
        return std::max(std::size_t{1}, static_cast<std::size_t>(std::ceil(columns)));
    }

    void makeProfiles(const Progress& progress) {
        constexpr std::size_t block = 64;
        forEachInBlocks(m_groups.size(), block, progress, [&](std::size_t group) {
            std::vector<OutlineSide> outline = m_groups[group].outline;
            for (OutlineSide& side : outline)
                for (Eigen::Vector2d& end : side)
                    end = (m_scale * end).array() + m_margin;
            const GroupProfile profile =
                profileOf(outline, m_margin, m_columnWidth, columnsOf(m_groups[group]));
            for (std::size_t i = 0; i < groupStances.size(); ++i)
                m_profiles[group][i] = mirrored(profile, groupStances[i]);
        });
    }

    /// Columns around the lowest one of the skyline that are hardly higher.
    struct Valley {
        std::size_t first, end;
        std::int32_t floor; ///< profile units
    };

    Valley lowestValley() const {
        const auto lowest = std::min_element(m_skyline.begin(), m_skyline.end());
        const auto column = static_cast<std::size_t>(lowest - m_skyline.begin());
        const std::int32_t highest =
            *lowest + static_cast<std::int32_t>(valleyDepth * m_profiles[m_waiting.first()][0].height);
        Valley valley{column, column + 1, *lowest};
        while (valley.first > 0 && m_skyline[valley.first - 1] <= highest)
            --valley.first;
        while (valley.end < m_skyline.size() && m_skyline[valley.end] <= highest)
            ++valley.end;
        return valley;
    }

    /// Of groups at either end of the valley, the place that leaves least room empty. In its middle nothing
    /// is tried: a group there leaves two gaps instead of one. Groups too tall for what is left of the page
    /// are passed over and not counted, so that at its end small ones have their turn.
    std::optional<GroupPlace> bestPlace(const Valley& valley) {
        std::optional<GroupPlace> best;
        double least = std::numeric_limits<double>::infinity();
        std::size_t compared = 0;
        m_waiting.forFirst(m_groups.size(), [&](std::uint32_t group, std::uint32_t link) {
            const std::array<GroupProfile, 4>& profiles = m_profiles[group];
            if (profiles[0].height > pageHeight() - valley.floor) return true;
            const auto columns = static_cast<std::ptrdiff_t>(profiles[0].top.size());
            for (int tenths = 0; tenths <= mostTenthsBack; ++tenths) {
                const std::ptrdiff_t back = tenths * columns / 10;
                if (tenths > 0 && back == 0) continue;
                const auto first = static_cast<std::ptrdiff_t>(valley.first) - back;
                const auto last = static_cast<std::ptrdiff_t>(valley.end) - columns + back;
                for (const std::ptrdiff_t place : {first, last}) {
                    if (place < 0 || place + columns > static_cast<std::ptrdiff_t>(m_skyline.size()))
                        continue;
                    tryAt({group, link, 0, static_cast<std::size_t>(place), 0}, least, best);
                }
            }
            return ++compared < mostComparedGroups;
        });
        return best;
    }

    /// In the stance that is best there.
    void tryAt(GroupPlace place, double& least, std::optional<GroupPlace>& best) const {
        const std::array<GroupProfile, 4>& profiles = m_profiles[place.group];
        const std::size_t columns = profiles[0].top.size();
        const std::int64_t taken = takenIn(place.column, columns);
        for (place.stance = 0; place.stance < profiles.size(); ++place.stance) {
            const GroupProfile& profile = profiles[place.stance];
            place.y = restOf(profile, place.column);
            if (place.y + profile.height > pageHeight()) continue;
            const std::int64_t empty = static_cast<std::int64_t>(columns) * place.y + profile.above - taken;
            // Empty room for each part of the group's own area: else points and slivers would always be
            // first.
            const double waste =
                static_cast<double>(empty) / std::max(m_groups[place.group].area, m_smallestArea);
            if (!(waste < least)) continue;
            least = waste;
            best = place;
        }
    }

    /// How high a group can lie: as far up as its upper profile leaves it anywhere.
    std::int32_t restOf(const GroupProfile& profile, std::size_t column) const {
        std::int32_t y = 0;
        const std::int32_t* skyline = &m_skyline[column];
        for (std::size_t i = 0; i < profile.top.size(); ++i)
            y = std::max(y, skyline[i] - profile.top[i]);
        return y;
    }

    /// Of some columns together.
    std::int64_t takenIn(std::size_t column, std::size_t columns) const {
        const auto first = m_skyline.begin() + static_cast<std::ptrdiff_t>(column);
        return std::accumulate(first, first + static_cast<std::ptrdiff_t>(columns), std::int64_t{0});
    }

    void lay(const GroupPlace& place) {
        const GroupProfile& profile = m_profiles[place.group][place.stance];
        const std::size_t columns = profile.top.size();
        for (std::size_t i = 0; i < columns; ++i)
            m_skyline[place.column + i] = std::max(m_skyline[place.column + i], place.y + profile.bottom[i]);
        m_lowest = std::max(m_lowest, place.y + profile.height);
        layTriangles(place, static_cast<double>(columns) * m_columnWidth,
                     static_cast<double>(profile.height) / profileUnits);
        m_laidArea += m_groups[place.group].area;
        m_waiting.take(place.link);
    }

    /// In a box of so many pixels.
    void layTriangles(const GroupPlace& place, double width, double height) {
        const TurnedGroup& group = m_groups[place.group];
        const GroupStance& stance = groupStances[place.stance];
        const Eigen::Vector2d box(static_cast<double>(place.column) * m_columnWidth,
                                  static_cast<double>(place.y) / profileUnits);
        for (std::size_t i = 0; i < group.corners.size(); ++i) {
            const std::size_t triangle = m_firstTriangles[place.group] + i;
            m_layout.page[triangle] = static_cast<std::uint16_t>(m_pageNumber);
            for (std::size_t corner = 0; corner < 3; ++corner) {
                Eigen::Vector2d point = (m_scale * group.corners[i][corner]).array() + m_margin;
                if (stance.leftIsRight) point.x() = width - point.x();
                if (stance.topIsBottom) point.y() = height - point.y();
                m_layout.corners[triangle][corner] = box + point;
            }
        }
    }

    /// Closes a valley for which nothing that waits is small enough, and the page when it was the last one.
    /// False when there is no other page.
    bool moveOn(const Valley& valley) {
        std::fill(m_skyline.begin() + static_cast<std::ptrdiff_t>(valley.first),
                  m_skyline.begin() + static_cast<std::ptrdiff_t>(valley.end), pageHeight());
        if (*std::min_element(m_skyline.begin(), m_skyline.end()) < pageHeight()) return true;
        std::fill(m_skyline.begin(), m_skyline.end(), 0);
        m_lowest = 0;
        return ++m_pageNumber < m_mostPages;
    }

    /// So much area took all the pages: all of it would take as many more in proportion. The search for a
    /// scale goes on from that height without a layout that nobody wants.
    PatchLayout givenUp() const {
        PatchLayout layout;
        layout.pages = m_laidArea > 0 ? m_mostPages + 1 : 0;
        layout.height = m_laidArea > 0 ? m_mostPages * room() * m_area / m_laidArea : 0;
        return layout;
    }

    const std::vector<TurnedGroup>& m_groups;
    double m_scale, m_margin;
    PageRoom m_page;
    int m_mostPages;
    double m_columnWidth;                ///< pixels
    std::vector<std::int32_t> m_skyline; ///< per column, to where the page is full; profile units
    std::vector<std::array<GroupProfile, 4>> m_profiles;
    WaitingPatches m_waiting;
    std::vector<std::size_t> m_firstTriangles; ///< of each group
    PatchLayout m_layout;
    double m_area = 0, m_laidArea = 0; ///< m²
    double m_smallestArea;             ///< m², that points without any count as
    int m_pageNumber = 0;
    std::int32_t m_lowest = 0; ///< profile units, to where groups reach on the page
};

} // namespace

TurnedGroup turned(const UnfoldedGroup& group) {
    std::vector<Eigen::Vector2d> points;
    for (const auto& corners : group.corners)
        points.insert(points.end(), corners.begin(), corners.end());
    const TurnedRectangle box = smallestRectangle(convexHull(std::move(points)));
    const Eigen::Vector2d across(-box.direction.y(), box.direction.x());
    TurnedGroup result{{}, {}, box.length, box.height, group.area};
    for (const auto& corners : group.corners) {
        PatchCorners& turnedCorners = result.corners.emplace_back();
        for (std::size_t i = 0; i < 3; ++i)
            turnedCorners[i] =
                Eigen::Vector2d(box.direction.dot(corners[i]), across.dot(corners[i])) - box.corner;
    }
    result.outline = outlineOf(result.corners);
    return result;
}

PatchLayout layoutGroups(const std::vector<TurnedGroup>& groups, double texelsPerMetre, const PageRoom& page,
                         int mostPages, const Progress& progress) {
    ProgressParts parts(progress);
    reportProgress(progress, 0);
    SkylinePacker packer(groups, texelsPerMetre, page, mostPages, parts.next(0.2));
    return packer.pack(parts.rest());
}

} // namespace esm
