#include "core/geometry/hole_filling.h"

#include "core/geometry/adjacency.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <set>

namespace esm {

namespace {

/// Turns of the surface within these steps count as alike; the shorter chords then decide.
constexpr double turnStep = 5; // degrees
/// What turns by more lies back on the surface that it should go on with.
constexpr double mostTurn = 160; // degrees
/// Height of a triangle over its longest side, below which it counts as a line.
constexpr double leastThickness = 1e-6;

double degreesBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::acos(std::clamp(a.dot(b), -1.0, 1.0)) * 180 / M_PI;
}

/// How bad a filling is.
struct Badness {
    int turn = 0;      ///< the sharpest between neighbouring triangles, in steps
    double length = 0; ///< of the chords, squared and added up

    bool operator<(const Badness& other) const {
        return turn != other.turn ? turn < other.turn : length < other.length;
    }
};
constexpr int impossible = std::numeric_limits<int>::max();

// Barequet and Sharir 1995, with Liepa's order of what counts (2003): of all ways to fill a polygon in space
// with triangles between its corners, one whose sharpest turn, also towards the surface around it, is least.
// What is alike in this is decided by the length of the chords, which gives well shaped triangles where a
// hole is flat. The best filling of the corners i to k, closed by the chord between both, is one of a
// triangle (i, m, k) and the best fillings on its two other sides: a table over i and k, each entry a search
// over m. That is exact but for the turn at a chord, which is that towards the best filling beyond it.
class HoleFiller {
public:
    HoleFiller(const std::vector<Eigen::Vector3d>& vertices, const BorderLoop& loop,
               std::vector<Eigen::Vector3d> aroundNormals, std::vector<bool> isTaken)
        : m_vertices(vertices), m_loop(loop), m_count(loop.size()), m_around(std::move(aroundNormals)),
          m_isTaken(std::move(isTaken)), m_best(m_count * m_count), m_middle(m_count * m_count, 0),
          m_normals(m_count * m_count, Eigen::Vector3d::Zero()) {}

    /// Empty where there is none.
    std::vector<Triangle> fill(const Progress& progress) {
        for (std::size_t span = 2; span < m_count; ++span) {
            reportProgress(progress, static_cast<double>(span) / static_cast<double>(m_count));
            for (std::size_t i = 0; i + span < m_count; ++i)
                choose(i, i + span);
        }
        std::vector<Triangle> triangles;
        if (m_best[m_count - 1].turn <= mostTurn / turnStep) collect(0, m_count - 1, triangles);
        return triangles;
    }

private:
    std::size_t entry(std::size_t i, std::size_t k) const { return i * m_count + k; }
    const Eigen::Vector3d& at(std::size_t corner) const { return m_vertices[m_loop[corner]]; }
    bool isWhole(std::size_t i, std::size_t k) const { return i == 0 && k + 1 == m_count; }

    void choose(std::size_t i, std::size_t k) {
        Badness& best = m_best[entry(i, k)];
        best.turn = impossible;
        if (!isWhole(i, k) && m_isTaken[entry(i, k)]) return;
        const double chord = isWhole(i, k) ? 0 : (at(i) - at(k)).squaredNorm();
        for (std::size_t m = i + 1; m < k; ++m) {
            Badness badness = both(m_best[entry(i, m)], m_best[entry(m, k)]);
            if (badness.turn == impossible || best.turn < badness.turn) continue;
            const auto normal = normalOf(i, m, k);
            if (!normal) continue;
            badness.length += chord;
            badness.turn = std::max(badness.turn, turnAt(i, m, k, *normal));
            if (!(badness < best)) continue;
            best = badness;
            m_middle[entry(i, k)] = m;
            m_normals[entry(i, k)] = *normal;
        }
    }

    static Badness both(const Badness& a, const Badness& b) {
        return {std::max(a.turn, b.turn), a.length + b.length};
    }

    /// As the filling runs, against the border; none of a line.
    std::optional<Eigen::Vector3d> normalOf(std::size_t i, std::size_t m, std::size_t k) const {
        const Eigen::Vector3d u = at(m) - at(k), v = at(i) - at(k), normal = u.cross(v);
        const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()});
        const double size = normal.norm();
        if (!(size > leastThickness * longest)) return std::nullopt;
        return normal / size;
    }

    int turnAt(std::size_t i, std::size_t m, std::size_t k, const Eigen::Vector3d& normal) const {
        double turn = std::max(degreesBetween(normal, beyond(i, m)), degreesBetween(normal, beyond(m, k)));
        if (isWhole(i, k)) turn = std::max(turn, degreesBetween(normal, m_around[k]));
        return static_cast<int>(turn / turnStep);
    }

    const Eigen::Vector3d& beyond(std::size_t i, std::size_t k) const {
        return k == i + 1 ? m_around[i] : m_normals[entry(i, k)];
    }

    void collect(std::size_t i, std::size_t k, std::vector<Triangle>& triangles) const {
        if (k == i + 1) return;
        const std::size_t m = m_middle[entry(i, k)];
        triangles.push_back({m_loop[k], m_loop[m], m_loop[i]});
        collect(i, m, triangles);
        collect(m, k, triangles);
    }

    const std::vector<Eigen::Vector3d>& m_vertices;
    const BorderLoop& m_loop;
    std::size_t m_count;
    std::vector<Eigen::Vector3d> m_around; ///< normals across the border's edges
    std::vector<bool> m_isTaken;           ///< pairs of corners that an edge joins already
    std::vector<Badness> m_best;
    std::vector<std::size_t> m_middle;
    std::vector<Eigen::Vector3d> m_normals;
};

/// What the surface has around a hole.
class HoleSurroundings {
public:
    HoleSurroundings(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Triangle>& triangles)
        : m_vertices(vertices), m_triangles(triangles), m_sides(sidesByEdge(triangles)) {}

    std::vector<Eigen::Vector3d> normalsAround(const BorderLoop& loop) const {
        std::vector<Eigen::Vector3d> normals;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const auto side = sideOf(loop[i], loop[(i + 1) % loop.size()]);
            const Triangle& t = m_triangles[side->triangle];
            normals.push_back((m_vertices[t[1]] - m_vertices[t[0]])
                                  .cross(m_vertices[t[2]] - m_vertices[t[0]])
                                  .stableNormalized());
        }
        return normals;
    }

    std::vector<bool> takenChords(const BorderLoop& loop) const {
        std::vector<bool> isTaken(loop.size() * loop.size(), false);
        for (std::size_t i = 0; i < loop.size(); ++i)
            for (std::size_t k = i + 2; k < loop.size(); ++k)
                isTaken[i * loop.size() + k] = isEdge(loop[i], loop[k]);
        return isTaken;
    }

    void add(const std::vector<Triangle>& filling) {
        for (const Triangle& triangle : filling)
            for (std::size_t corner = 0; corner < 3; ++corner)
                m_added.insert(std::minmax(triangle[corner], triangle[(corner + 1) % 3]));
    }

private:
    std::vector<TriangleSide>::const_iterator sideOf(std::uint32_t a, std::uint32_t b) const {
        const Edge edge = std::minmax(a, b);
        return std::lower_bound(
            m_sides.begin(), m_sides.end(), edge,
            [](const TriangleSide& side, const Edge& other) { return side.edge < other; });
    }
    bool isEdge(std::uint32_t a, std::uint32_t b) const {
        const Edge edge = std::minmax(a, b);
        const auto side = sideOf(a, b);
        return (side != m_sides.end() && side->edge == edge) || m_added.count(edge) > 0;
    }

    const std::vector<Eigen::Vector3d>& m_vertices;
    const std::vector<Triangle>& m_triangles;
    std::vector<TriangleSide> m_sides;
    std::set<Edge> m_added; ///< by fillings
};

/// To fill a hole, in proportion.
double costOf(const BorderLoop& loop) {
    return std::pow(static_cast<double>(loop.size()), 3);
}

} // namespace

std::vector<bool> fillHoles(const std::vector<Eigen::Vector3d>& vertices, std::vector<Triangle>& triangles,
                            const std::vector<BorderLoop>& loops, const Progress& progress) {
    HoleSurroundings surroundings(vertices, triangles);
    std::vector<Triangle> added;
    std::vector<bool> isFilled;
    ProgressParts parts(progress);
    const double allCosts =
        std::accumulate(loops.begin(), loops.end(), 0.0,
                        [](double sum, const BorderLoop& loop) { return sum + costOf(loop); });
    for (const BorderLoop& loop : loops) {
        const std::vector<Triangle> filling =
            HoleFiller(vertices, loop, surroundings.normalsAround(loop), surroundings.takenChords(loop))
                .fill(parts.next(costOf(loop) / allCosts));
        surroundings.add(filling);
        added.insert(added.end(), filling.begin(), filling.end());
        isFilled.push_back(!filling.empty());
    }
    triangles.insert(triangles.end(), added.begin(), added.end());
    return isFilled;
}

} // namespace esm
