#include "core/solid/crossings.h"

#include "core/geometry/cells_at_points.h"
#include "core/geometry/disjoint_sets.h"
#include "core/geometry/principal_axes.h"
#include "core/solid/parallel_nodes.h"
#include "core/solid/self_intersections.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace esm {

namespace {

using Eigen::Vector3d;

// Folds of segmented organs are threads: long where a sharp rim runs through itself, and thinner than any
// lattice. So the extent that counts is not the largest one. Along the axes along which points spread most
// and least the tube lies and is thinnest.
double tubeWidth(const std::vector<Vector3d>& points) {
    const Vector3d middle = meanOf(points);
    const Eigen::Matrix3d axes = principalAxes(points);
    Eigen::AlignedBox3d box;
    for (const Vector3d& point : points)
        box.extend(axes.transpose() * (point - middle));
    Eigen::Array3d extents = box.sizes().array();
    std::sort(extents.begin(), extents.end());
    return extents[1];
}

/// The surfaces of all bodies as one.
struct JoinedSurface {
    TriangleMesh mesh;            ///< facing away from the tissue
    std::vector<double> spacings; ///< per vertex, of its body's lattice
};

// Shells of an organ may face either way, and only as bodies do they face away from the tissue, so that
// winding numbers tell. Bodies also cross each other, which has to be narrow for both of them.
JoinedSurface joinedSurface(const std::vector<ClosedBody>& bodies, const std::vector<double>& spacings) {
    JoinedSurface result;
    TriangleMesh& mesh = result.mesh;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const TriangleMesh& surface = bodies[i].surface;
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), surface.vertices.begin(), surface.vertices.end());
        for (const Triangle& triangle : surface.triangles)
            mesh.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
        result.spacings.resize(mesh.vertices.size(), spacings[i]);
    }
    return result;
}

struct CrossingPlace {
    std::vector<Vector3d> points; ///< corners of all that crosses or is misplaced
    std::size_t pairs = 0;
    double spacing = std::numeric_limits<double>::infinity();

    Crossing crossing() const { return {pairs, meanOf(points), tubeWidth(points), spacing}; }
};

class CrossingFinder {
public:
    CrossingFinder(const JoinedSurface& surface, const Progress& progress)
        : m_mesh(surface.mesh), m_spacings(surface.spacings),
          m_pairs(meetingTriangles(surface.mesh, progress)),
          m_trianglesAt(m_mesh.triangles, m_mesh.vertices.size()), m_sets(m_mesh.vertices.size()),
          m_isMisplaced(m_mesh.vertices.size(), 0) {
        for (const MeetingTriangles& pair : m_pairs)
            for (const std::uint32_t triangle : {pair.one, pair.other})
                join(m_mesh.triangles[triangle], m_mesh.triangles[pair.one][0]);
    }

    /// By the lowest vertex of each.
    std::map<std::uint32_t, CrossingPlace> places() {
        std::map<std::uint32_t, CrossingPlace> places;
        for (const MeetingTriangles& pair : m_pairs) {
            CrossingPlace& place = places[placeOf(pair)];
            ++place.pairs;
            const std::vector<Vector3d> points = piercings(m_mesh, pair.one, pair.other);
            place.points.insert(place.points.end(), points.begin(), points.end());
            for (const std::uint32_t triangle : {pair.one, pair.other})
                place.spacing = std::min(place.spacing, m_spacings[m_mesh.triangles[triangle][0]]);
        }
        for (std::uint32_t vertex = 0; vertex < m_isMisplaced.size(); ++vertex)
            if (m_isMisplaced[vertex])
                places[m_sets.lowest(vertex)].points.push_back(m_mesh.vertices[vertex]);
        return places;
    }

    // Where surfaces cross, each goes on beyond the other and comes back across the same curve. What lies
    // beyond hangs together with triangles that meet, and is found from there, ring by ring. Of a wide place
    // it could be half the organ, and would tell nothing new.
    void findMisplaced(const Progress& progress) {
        std::map<std::uint32_t, bool> isNarrow;
        for (const auto& [vertex, place] : places())
            isNarrow[vertex] = place.crossing().isNarrow();
        std::vector<char> isAsked(m_mesh.vertices.size(), 0);
        std::vector<std::uint32_t> ring;
        const auto ask = [&](std::uint32_t triangle) {
            for (const std::uint32_t vertex : m_mesh.triangles[triangle])
                if (!std::exchange(isAsked[vertex], 1)) ring.push_back(vertex);
        };
        for (const MeetingTriangles& pair : m_pairs)
            if (isNarrow[placeOf(pair)])
                for (const std::uint32_t triangle : {pair.one, pair.other})
                    ask(triangle);
        ProgressParts parts(progress);
        while (!ring.empty()) {
            const std::vector<std::uint32_t> asked = std::exchange(ring, {});
            const auto look = [&](std::size_t i) { m_isMisplaced[asked[i]] = isMisplaced(asked[i]) ? 1 : 0; };
            forEachInBlocks(asked.size(), 4, parts.nextOfRest(0.7), look);
            for (const std::uint32_t vertex : asked)
                if (m_isMisplaced[vertex])
                    m_trianglesAt.forEachAt(vertex, [&](std::uint32_t triangle) {
                        join(m_mesh.triangles[triangle], vertex);
                        ask(triangle);
                    });
        }
        reportProgress(progress, 1);
    }

private:
    std::uint32_t placeOf(const MeetingTriangles& pair) {
        return m_sets.lowest(m_mesh.triangles[pair.one][0]);
    }
    void join(const Triangle& triangle, std::uint32_t vertex) {
        for (const std::uint32_t corner : triangle)
            m_sets.join(corner, vertex);
    }
    // Its own triangles are seen edge-on and do not count: at a border of tissue the others wind around it by
    // the part of all directions in which the tissue lies.
    bool isMisplaced(std::uint32_t vertex) const {
        return std::abs(windingNumber(m_mesh, m_mesh.vertices[vertex]) - 0.5) > 0.5 + 1e-9;
    }

    const TriangleMesh& m_mesh;
    const std::vector<double>& m_spacings;
    std::vector<MeetingTriangles> m_pairs;
    CellsAtPoints m_trianglesAt;
    DisjointSets m_sets; ///< of vertices, those of one place in one
    std::vector<char> m_isMisplaced;
};

} // namespace

// Where a surface runs through itself the winding number is 2 or below 0 in a small region instead of 1 or 0.
// The region's border is made of what is misplaced, and ends at the curves where triangles meet, so that it
// lies within the hull of the curves' corners and of the misplaced vertices. How large that is says how far
// any point can be taken for inside or outside wrongly.
std::vector<Crossing> crossingsOf(const std::vector<ClosedBody>& bodies, const std::vector<double>& spacings,
                                  const Progress& progress) {
    const JoinedSurface surface = joinedSurface(bodies, spacings);
    ProgressParts parts(progress);
    CrossingFinder finder(surface, parts.next(0.3));
    finder.findMisplaced(parts.rest());
    std::vector<Crossing> crossings;
    for (const auto& [vertex, place] : finder.places())
        crossings.push_back(place.crossing());
    return crossings;
}

} // namespace esm
