#include "core/geometry/slit_pairing.h"

#include <algorithm>
#include <optional>

namespace esm {

namespace {

/// Vertices may be so much farther apart than the borders themselves and still become one: they then lie up
/// to 1.1 widths beside each other, which is less distortion than a sliver would be.
constexpr double vertexReach = 1.5;
/// Against rounding: a gap of exactly the width is closed.
constexpr double tolerance = 1 + 1e-6;
/// Vertices of both sides become one where they lie so near along the border, as a share of the mean
/// distance between vertices. Others divide the edge opposite, in parts no smaller than that.
constexpr double nearAlong = 0.3;

struct End {
    std::uint32_t anchor;
    bool isOther; ///< the pair's other place
    BorderPlace place;
};

/// What lies between two places, going along the border.
struct Chain {
    std::vector<std::uint32_t> corners;                 ///< without those of the ends
    std::vector<double> shares;                         ///< of the chain's length, to each of them
    std::vector<std::pair<BorderPlace, double>> starts; ///< of its edges, with their shares
    double endAlong = 1;                                ///< of the last edge
};

// Where vertices of two borders are each other's nearest they anchor the borders to each other; a vertex that
// has none near it is anchored to a place of the edge across. Between two anchors that follow each other on
// both borders, vertices are paired by their share of the way, as with a zip fastener: so both sides may have
// any number of them, and a crooked border cannot cross itself. Where anchors follow each other in another
// order, as where three borders come together, nothing is paired.
class Pairing {
public:
    Pairing(const std::vector<Eigen::Vector3d>& vertices, const BorderCorners& corners, double width)
        : m_vertices(vertices), m_corners(corners), m_width(width * tolerance), m_loops(vertices.size(), 0) {
        for (const std::uint32_t vertex : corners.vertex)
            ++m_loops[vertex];
        findAnchors();
        sortEnds();
    }

    std::vector<SlitStretch> stretches() const {
        std::vector<SlitStretch> found;
        for (std::uint32_t i = 0; i < m_ends.size(); ++i)
            if (auto stretch = stretchFrom(i)) found.push_back(std::move(*stretch));
        return found;
    }

private:
    const Eigen::Vector3d& at(std::uint32_t corner) const { return m_vertices[m_corners.vertex[corner]]; }
    Eigen::Vector3d at(const BorderPlace& place) const { return positionOf(place, m_corners, m_vertices); }
    bool isOfOneLoop(std::uint32_t corner) const { return m_loops[m_corners.vertex[corner]] == 1; }
    double distance(std::uint32_t a, std::uint32_t b) const { return (at(a) - at(b)).norm(); }

    void findAnchors() {
        const BorderSearch search(m_vertices, m_corners);
        std::vector<std::optional<BorderSearch::Opposite>> opposite(m_corners.size());
        std::vector<std::uint32_t> nearest(m_corners.size(), noIndex);
        for (std::uint32_t i = 0; i < m_corners.size(); ++i) {
            if (!isOfOneLoop(i)) continue;
            opposite[i] = search.oppositeOf(i, m_width);
            if (opposite[i]) nearest[i] = nearerEnd(i, opposite[i]->corner);
        }
        answerThoseBeyondReach(opposite, nearest);
        for (std::uint32_t i = 0; i < m_corners.size(); ++i) {
            if (!opposite[i]) continue;
            const std::uint32_t other = nearest[i];
            if (distance(i, other) > vertexReach * m_width)
                m_anchors.push_back({{i, 0}, {opposite[i]->corner, opposite[i]->along}});
            else if (nearest[other] == i && (i < other || !opposite[other]) && isOfOneLoop(other) &&
                     !areNeighbours(i, other))
                m_anchors.push_back({{i, 0}, {other, 0}});
        }
    }

    /// A vertex whose own perpendicular misses the border across, as before a notch, takes the nearest of
    /// those that found it.
    void answerThoseBeyondReach(const std::vector<std::optional<BorderSearch::Opposite>>& opposite,
                                std::vector<std::uint32_t>& nearest) const {
        for (std::uint32_t i = 0; i < m_corners.size(); ++i) {
            if (!opposite[i] || opposite[nearest[i]]) continue;
            std::uint32_t& answer = nearest[nearest[i]];
            if (answer == noIndex || distance(i, nearest[i]) < distance(answer, nearest[i])) answer = i;
        }
    }
    bool areNeighbours(std::uint32_t a, std::uint32_t b) const {
        return m_corners.next[a] == b || m_corners.previous[a] == b;
    }
    std::uint32_t nearerEnd(std::uint32_t corner, std::uint32_t edge) const {
        const std::uint32_t end = m_corners.next[edge];
        return distance(corner, edge) <= distance(corner, end) ? edge : end;
    }

    void sortEnds() {
        for (std::uint32_t i = 0; i < m_anchors.size(); ++i) {
            m_ends.push_back({i, false, m_anchors[i].one});
            m_ends.push_back({i, true, m_anchors[i].other});
        }
        std::sort(m_ends.begin(), m_ends.end(), [](const End& a, const End& b) {
            return std::tuple(a.place.corner, a.place.along, a.anchor, a.isOther) <
                   std::tuple(b.place.corner, b.place.along, b.anchor, b.isOther);
        });
        m_placeOf.resize(m_ends.size());
        for (std::uint32_t i = 0; i < m_ends.size(); ++i)
            m_placeOf[2 * m_ends[i].anchor + m_ends[i].isOther] = i;
        m_next.resize(m_ends.size());
        for (std::uint32_t first = 0; first < m_ends.size();) {
            std::uint32_t last = first;
            while (last < m_ends.size() && loopOf(last) == loopOf(first))
                ++last;
            for (std::uint32_t i = first; i < last; ++i)
                m_next[i] = i + 1 < last ? i + 1 : first;
            first = last;
        }
    }
    std::uint32_t loopOf(std::uint32_t end) const { return m_corners.loop[m_ends[end].place.corner]; }
    /// The other end of the same anchor.
    std::uint32_t across(std::uint32_t end) const {
        return m_placeOf[2 * m_ends[end].anchor + !m_ends[end].isOther];
    }

    std::optional<SlitStretch> stretchFrom(std::uint32_t end) const {
        const std::uint32_t next = m_next[end];
        if (next == across(end)) return capAt(end);
        const std::uint32_t otherEnd = across(end), otherNext = across(next);
        // Each is found from both of its borders.
        if (next == end || m_next[otherNext] != otherEnd || otherNext < end) return std::nullopt;
        SlitStretch stretch{pairOf(end)};
        const Chain one = chain(m_ends[end].place, m_ends[next].place);
        const Chain other = chain(m_ends[otherNext].place, m_ends[otherEnd].place);
        pairBetween(one, other, stretch);
        stretch.push_back(pairOf(next));
        return isWithinReach(stretch) ? std::optional(std::move(stretch)) : std::nullopt;
    }

    PlacePair pairOf(std::uint32_t end) const { return {m_ends[end].place, m_ends[across(end)].place}; }

    /// The end of a slit, where one vertex is left between the two that are joined: its two edges become one.
    std::optional<SlitStretch> capAt(std::uint32_t end) const {
        if (chain(m_ends[end].place, m_ends[m_next[end]].place).corners.size() != 1) return std::nullopt;
        return SlitStretch{pairOf(end)};
    }

    Chain chain(const BorderPlace& from, const BorderPlace& to) const {
        Chain chain;
        double length = 0;
        Eigen::Vector3d last = at(from);
        chain.starts.emplace_back(from, 0);
        std::uint32_t corner = from.corner;
        // A loop that holds both places may have to be gone round to come to the second.
        bool arrives = from.corner == to.corner && from.along < to.along;
        while (!arrives) {
            corner = m_corners.next[corner];
            if (corner == to.corner && to.isCorner()) break;
            length += (at(corner) - last).norm();
            last = at(corner);
            chain.corners.push_back(corner);
            chain.shares.push_back(length);
            chain.starts.emplace_back(BorderPlace{corner, 0}, length);
            arrives = corner == to.corner;
        }
        length += (at(to) - last).norm();
        for (double& share : chain.shares)
            share /= length;
        for (auto& start : chain.starts)
            start.second /= length;
        if (!to.isCorner()) chain.endAlong = to.along;
        return chain;
    }

    /// The place at a share of a chain's length.
    static BorderPlace placeAt(const Chain& chain, double share) {
        std::size_t edge = chain.starts.size() - 1;
        while (edge > 0 && chain.starts[edge].second > share)
            --edge;
        const BorderPlace& start = chain.starts[edge].first;
        const bool isLast = edge + 1 == chain.starts.size();
        const double from = chain.starts[edge].second, to = isLast ? 1 : chain.starts[edge + 1].second;
        const double endAlong = isLast ? chain.endAlong : 1;
        return {start.corner, start.along + (share - from) / (to - from) * (endAlong - start.along)};
    }

    static void pairBetween(const Chain& one, const Chain& other, SlitStretch& stretch) {
        const std::size_t ones = one.corners.size(), others = other.corners.size();
        const auto shareOf = [&](std::size_t i) { return i < ones ? one.shares[i] : 2; };
        // The other is followed backwards.
        const auto otherShareOf = [&](std::size_t j) {
            return j < others ? 1 - other.shares[others - 1 - j] : 2;
        };
        const double near = nearAlong / static_cast<double>(std::max(ones, others) + 1);
        for (std::size_t i = 0, j = 0; i < ones || j < others;) {
            const double share = shareOf(i), otherShare = otherShareOf(j);
            const bool keepsOrder = shareOf(i + 1) > otherShare && otherShareOf(j + 1) > share;
            if (keepsOrder && std::abs(share - otherShare) <= near)
                stretch.push_back({{one.corners[i++], 0}, {other.corners[others - 1 - j++], 0}});
            else if (share < otherShare)
                stretch.push_back({{one.corners[i++], 0}, placeAt(other, 1 - share)});
            else
                stretch.push_back({placeAt(one, otherShare), {other.corners[others - 1 - j++], 0}});
        }
    }

    bool isWithinReach(const SlitStretch& stretch) const {
        return std::all_of(stretch.begin(), stretch.end(), [this](const PlacePair& pair) {
            return (at(pair.one) - at(pair.other)).norm() <= vertexReach * m_width &&
                   (!pair.one.isCorner() || isOfOneLoop(pair.one.corner)) &&
                   (!pair.other.isCorner() || isOfOneLoop(pair.other.corner));
        });
    }

    const std::vector<Eigen::Vector3d>& m_vertices;
    const BorderCorners& m_corners;
    double m_width;
    std::vector<std::uint32_t> m_loops; ///< of each vertex
    std::vector<PlacePair> m_anchors;
    std::vector<End> m_ends;              ///< of anchors, along the loops
    std::vector<std::uint32_t> m_placeOf; ///< among the ends, of each anchor's one and other
    std::vector<std::uint32_t> m_next;    ///< end along the loop
};

} // namespace

Eigen::Vector3d positionOf(const BorderPlace& place, const BorderCorners& corners,
                           const std::vector<Eigen::Vector3d>& vertices) {
    const Eigen::Vector3d& start = vertices[corners.vertex[place.corner]];
    if (place.isCorner()) return start;
    return start + place.along * (vertices[corners.vertex[corners.next[place.corner]]] - start);
}

std::vector<SlitStretch> slitStretches(const std::vector<Eigen::Vector3d>& vertices,
                                       const BorderCorners& corners, double width) {
    return Pairing(vertices, corners, width).stretches();
}

} // namespace esm
