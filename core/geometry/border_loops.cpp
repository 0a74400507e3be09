#include "core/geometry/border_loops.h"

#include "core/geometry/adjacency.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>

namespace esm {

namespace {

struct BorderEdge {
    std::uint32_t from, to;
    std::uint32_t triangle;
    std::uint32_t next = noIndex; ///< border edge that goes on at `to`
    bool isFollowed = false;      ///< is the next of another
};

std::vector<BorderEdge> borderEdges(const std::vector<Triangle>& triangles) {
    std::vector<BorderEdge> edges;
    forEachEdge(sidesByEdge(triangles), [&](auto first, auto last) {
        if (last - first != 1) return;
        const auto [low, high] = first->edge;
        edges.push_back({first->forward ? low : high, first->forward ? high : low, first->triangle});
    });
    return edges;
}

std::size_t cornerOf(const Triangle& triangle, std::uint32_t vertex) {
    return static_cast<std::size_t>(std::find(triangle.begin(), triangle.end(), vertex) - triangle.begin());
}

// An edge goes on with the other border edge of the fan of triangles around its end. Where several parts of
// the surface touch in that vertex, each fan has its own two border edges, so that none is taken for
// another's. A fan that ends where surfaces branch has but one. It is joined to the one other such fan at
// its vertex, if there is one: a hole may lie across the seam of two sheets.
class BorderWalker {
public:
    explicit BorderWalker(const std::vector<Triangle>& triangles)
        : m_triangles(triangles), m_across(trianglesAcross(triangles)), m_edges(borderEdges(triangles)) {
        joinAroundFans();
        joinAcrossSeams();
    }

    Borders loops() {
        Borders borders;
        std::vector<bool> isDone(m_edges.size(), false);
        const auto walkFrom = [&](std::uint32_t start) {
            BorderLoop walked;
            for (std::uint32_t at = start; at != noIndex && !isDone[at]; at = m_edges[at].next) {
                isDone[at] = true;
                walked.push_back(m_edges[at].from);
            }
            return walked;
        };
        for (std::uint32_t i = 0; i < m_edges.size(); ++i)
            if (!m_edges[i].isFollowed) borders.looseEdges += walkFrom(i).size();
        for (std::uint32_t i = 0; i < m_edges.size(); ++i)
            if (!isDone[i]) addSimple(borders.loops, walkFrom(i));
        return borders;
    }

private:
    void join(BorderEdge& edge, std::uint32_t next) {
        edge.next = next;
        m_edges[next].isFollowed = true;
    }

    void joinAroundFans() {
        std::unordered_map<std::uint64_t, std::uint32_t> bySide; // triangle and corner where the edge begins
        for (std::uint32_t i = 0; i < m_edges.size(); ++i)
            bySide[3ULL * m_edges[i].triangle + cornerOf(m_triangles[m_edges[i].triangle], m_edges[i].from)] =
                i;
        for (BorderEdge& edge : m_edges)
            for (std::uint32_t triangle = edge.triangle; triangle != noIndex;) {
                const std::size_t corner = cornerOf(m_triangles[triangle], edge.to);
                const auto next = bySide.find(3ULL * triangle + corner);
                if (next != bySide.end()) join(edge, next->second);
                triangle = m_across[triangle][corner];
            }
    }

    void joinAcrossSeams() {
        std::map<std::uint32_t, std::pair<std::vector<std::uint32_t>, std::vector<std::uint32_t>>> ends;
        for (std::uint32_t i = 0; i < m_edges.size(); ++i) {
            if (m_edges[i].next == noIndex) ends[m_edges[i].to].first.push_back(i);
            if (!m_edges[i].isFollowed) ends[m_edges[i].from].second.push_back(i);
        }
        for (const auto& [vertex, inAndOut] : ends)
            if (inAndOut.first.size() == 1 && inAndOut.second.size() == 1)
                join(m_edges[inAndOut.first.front()], inAndOut.second.front());
    }

    /// Whenever the way comes to a vertex again, what lies between is a loop of its own.
    static void addSimple(std::vector<BorderLoop>& loops, const BorderLoop& walked) {
        BorderLoop open;
        std::unordered_map<std::uint32_t, std::size_t> places;
        for (const std::uint32_t vertex : walked) {
            const auto [place, isNew] = places.try_emplace(vertex, open.size());
            if (!isNew) {
                const auto begin = open.begin() + static_cast<std::ptrdiff_t>(place->second);
                loops.emplace_back(begin, open.end());
                for (auto gone = begin + 1; gone != open.end(); ++gone)
                    places.erase(*gone);
                open.erase(begin + 1, open.end());
                continue;
            }
            open.push_back(vertex);
        }
        loops.push_back(std::move(open));
    }

    const std::vector<Triangle>& m_triangles;
    std::vector<Triangle> m_across;
    std::vector<BorderEdge> m_edges;
};

} // namespace

std::size_t Borders::edgeCount() const {
    return std::accumulate(loops.begin(), loops.end(), looseEdges,
                           [](std::size_t sum, const BorderLoop& loop) { return sum + loop.size(); });
}

Borders bordersOf(const std::vector<Triangle>& triangles) {
    return BorderWalker(triangles).loops();
}

double lengthOf(const BorderLoop& loop, const std::vector<Eigen::Vector3d>& vertices) {
    double length = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        length += (vertices[loop[(i + 1) % loop.size()]] - vertices[loop[i]]).norm();
    return length;
}

} // namespace esm
