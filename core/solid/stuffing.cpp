#include "core/solid/stuffing.h"

#include "core/geometry/cells_at_points.h"
#include "core/solid/parallel_nodes.h"
#include "core/solid/tetrahedron_cut.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace esm {

namespace {

using Eigen::Vector3d;

/// An edge of the background from a point within the body to one outside, and where it leaves.
struct CutEdge {
    std::uint32_t inner, outer;
    Vector3d place = Vector3d::Zero();
    double part = 0; ///< of the edge, that lies within

    Edge key() const { return std::minmax(inner, outer); }
};

std::vector<CutEdge> edgesToCut(const BackgroundLattice& background) {
    std::vector<CutEdge> cuts;
    for (const Tetrahedron& corners : background.tetrahedra)
        for (const std::uint32_t inner : corners)
            for (const std::uint32_t outer : corners)
                if (background.isInside[inner] && !background.isInside[outer]) cuts.push_back({inner, outer});
    std::sort(cuts.begin(), cuts.end(),
              [](const CutEdge& one, const CutEdge& other) { return one.key() < other.key(); });
    const auto isSame = [](const CutEdge& one, const CutEdge& other) { return one.key() == other.key(); };
    cuts.erase(std::unique(cuts.begin(), cuts.end(), isSame), cuts.end());
    return cuts;
}

// A cut lies where the edge first leaves the body, also where it comes back and leaves again: what is between
// the inner point and the cut is within. Where rounding hides the surface from the ray, the end that is
// nearer to it lies on it.
void placeCut(CutEdge& cut, const std::vector<Vector3d>& points, const BodyQuery& query) {
    const Vector3d &from = points[cut.inner], &to = points[cut.outer];
    if (const auto hit = query.firstBetween(from, to)) {
        cut.place = query.placeOf(*hit);
        cut.part = std::clamp(hit->distance / (to - from).norm(), 0.0, 1.0);
        return;
    }
    const RayHit atInner = query.nearest(from), atOuter = query.nearest(to);
    const bool isInner = atInner.distance < atOuter.distance;
    cut.place = query.placeOf(isInner ? atInner : atOuter);
    cut.part = isInner ? 0 : 1;
}

/// Draws points of the background onto the surface along its edges.
class SurfaceDrawer {
public:
    explicit SurfaceDrawer(BackgroundLattice& background)
        : m_background(background), m_at(background.tetrahedra, background.points.size()),
          m_sides(background.points.size()) {
        for (std::size_t i = 0; i < m_sides.size(); ++i)
            m_sides[i] = background.isInside[i] ? Side::Inside : Side::Outside;
    }

    // Nearest first over the whole surface, so that what moves least has its way and the order of points
    // does not matter but among equals. A point that was drawn takes all cuts of its edges with it.
    void draw(const std::vector<CutEdge>& cuts) {
        struct Wish {
            double part;
            std::uint32_t point, cut;
        };
        std::vector<Wish> wishes;
        for (std::uint32_t i = 0; i < cuts.size(); ++i) {
            wishes.push_back({cuts[i].part, cuts[i].inner, i});
            wishes.push_back({1 - cuts[i].part, cuts[i].outer, i});
        }
        std::sort(wishes.begin(), wishes.end(), [](const Wish& one, const Wish& other) {
            return std::tie(one.part, one.point, one.cut) < std::tie(other.part, other.point, other.cut);
        });
        for (const Wish& wish : wishes) {
            if (wish.part > farthestDrawn) break;
            const CutEdge& cut = cuts[wish.cut];
            const bool isCut = m_sides[cut.inner] != Side::On && m_sides[cut.outer] != Side::On;
            if (isCut && mayMove(wish.point, cut.place)) m_sides[wish.point] = Side::On;
        }
    }

    const std::vector<Side>& sides() const { return m_sides; }

private:
    /// Moves a point where all its tetrahedra stay upright, else not.
    bool mayMove(std::uint32_t point, const Vector3d& place) {
        const Vector3d before = m_background.points[point];
        m_background.points[point] = place;
        for (std::uint32_t i = m_at.starts[point]; i < m_at.starts[point + 1]; ++i) {
            const std::uint32_t number = m_at.numbers[i];
            if (volumeOf(m_background.tetrahedra[number], m_background.points) >=
                leastVolume * m_background.volumes[number])
                continue;
            m_background.points[point] = before;
            return false;
        }
        return true;
    }

    // Of an edge. Labelle and Shewchuk prove 0.41 for body-centred short edges and 0.25 for long ones; where
    // the volume is watched as well, 0.4 leaves fewer slivers in every kind.
    static constexpr double farthestDrawn = 0.4;
    static constexpr double leastVolume = 0.15; ///< of what a tetrahedron had

    BackgroundLattice& m_background;
    CellsAtPoints m_at;
    std::vector<Side> m_sides;
};

/// Puts together what is left of the tetrahedra.
class PieceTaker {
public:
    PieceTaker(const BackgroundLattice& background, const std::vector<Side>& sides,
               const std::vector<CutEdge>& cuts, const BodyQuery& query)
        : m_background(background), m_sides(sides), m_query(query), m_cuts(cuts),
          m_ofPoint(sides.size(), noIndex), m_ofCut(cuts.size(), noIndex) {}

    void take(std::uint32_t number) {
        const Tetrahedron& corners = m_background.tetrahedra[number];
        const auto sideOf = [&](std::uint32_t point) { return m_sides[point]; };
        std::vector<TetrahedronPiece> pieces = piecesWithin(corners, sideOf);
        if (pieces.empty() && isFilledCorner(number)) pieces.push_back(wholeOf(corners));
        for (const TetrahedronPiece& piece : pieces) {
            Tetrahedron nodes;
            for (std::size_t i = 0; i < 4; ++i)
                nodes[i] = nodeOf(piece.corners[i]);
            if (volumeOf(nodes, m_stuffed.nodes) < 0) std::swap(nodes[2], nodes[3]);
            m_stuffed.tetrahedra.push_back(nodes);
            m_stuffed.origins.push_back(number);
            m_stuffed.isWhole.push_back(piece.isWhole);
        }
    }

    StuffedLattice taken() && { return std::move(m_stuffed); }

private:
    /// Whether one with all corners on the surface has tissue inside, as at the corner of a block.
    bool isFilledCorner(std::uint32_t number) const {
        const Tetrahedron& corners = m_background.tetrahedra[number];
        const std::vector<Vector3d>& points = m_background.points;
        const bool isOn = std::all_of(corners.begin(), corners.end(),
                                      [&](std::uint32_t point) { return m_sides[point] == Side::On; });
        return isOn && volumeOf(corners, points) > leastFilled * m_background.volumes[number] &&
               m_query.contains(
                   (points[corners[0]] + points[corners[1]] + points[corners[2]] + points[corners[3]]) / 4);
    }

    std::uint32_t nodeOf(const Edge& corner) {
        if (corner.first == corner.second) {
            std::uint32_t& node = m_ofPoint[corner.first];
            if (node == noIndex)
                node =
                    added(m_background.points[corner.first], m_sides[corner.first] == Side::On, corner.first);
            return node;
        }
        const auto cut =
            std::lower_bound(m_cuts.begin(), m_cuts.end(), corner,
                             [](const CutEdge& one, const Edge& key) { return one.key() < key; });
        std::uint32_t& node = m_ofCut[static_cast<std::size_t>(cut - m_cuts.begin())];
        if (node == noIndex) node = added(cut->place, true, noIndex);
        return node;
    }

    std::uint32_t added(const Vector3d& place, bool isOnSurface, std::uint32_t point) {
        m_stuffed.nodes.push_back(place);
        m_stuffed.isOnSurface.push_back(isOnSurface);
        m_stuffed.points.push_back(point);
        return static_cast<std::uint32_t>(m_stuffed.nodes.size() - 1);
    }

    const BackgroundLattice& m_background;
    const std::vector<Side>& m_sides;
    const BodyQuery& m_query;
    const std::vector<CutEdge>& m_cuts;
    static constexpr double leastFilled = 0.3; ///< of what a tetrahedron had, else it is a sliver
    std::vector<std::uint32_t> m_ofPoint, m_ofCut;
    StuffedLattice m_stuffed;
};

} // namespace

// Isosurface stuffing (Labelle and Shewchuk 2007). Every edge that leaves the body is cut where it leaves.
// Points to which a cut is near are drawn onto it, nearest first, which takes the cuts that would leave
// slivers; what the surface still runs through is cut, by a few patterns that fit face to face. The lattice
// within stays as it is, and no tetrahedron is turned over, whatever the surface: pieces lie within upright
// ones. Chosen over moving all outer nodes onto the surface [R 3.3.1.3], which turns tetrahedra over where
// the surface bends, and over Delaunay's way, which gives up the lattice.
StuffedLattice stuffed(BackgroundLattice& background, const BodyQuery& query, const Progress& progress) {
    ProgressParts parts(progress);
    std::vector<CutEdge> cuts = edgesToCut(background);
    forEachNode(cuts.size(), parts.next(0.5),
                [&](std::size_t i) { placeCut(cuts[i], background.points, query); });
    SurfaceDrawer drawer(background);
    drawer.draw(cuts);
    PieceTaker taker(background, drawer.sides(), cuts, query);
    const Progress takes = parts.rest();
    for (std::uint32_t i = 0; i < background.tetrahedra.size(); ++i) {
        reportStep(takes, i, background.tetrahedra.size());
        taker.take(i);
    }
    return std::move(taker).taken();
}

} // namespace esm
