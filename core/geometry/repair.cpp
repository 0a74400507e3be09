#include "core/geometry/repair.h"

#include "core/geometry/adjacency.h"
#include "core/geometry/hole_filling.h"
#include "core/geometry/orientation.h"
#include "core/geometry/polygon_split.h"
#include "core/geometry/slit_closing.h"
#include "core/geometry/sorted_by_vertex.h"
#include "core/geometry/weld.h"
#include "core/support/errors.h"
#include "core/support/offenders.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace esm {

namespace {

constexpr double largestCoordinate = 1e12;  // beyond it areas and volumes lose their meaning in double
constexpr std::size_t mostCorners = 10'000; // cutting ears takes the square of it, 10⁸ tests and more

/// The triangles of a soup under repair; indices are those of the soup's vertices.
struct Workpiece {
    const PolygonSoup& soup;
    std::vector<Eigen::Vector3d> vertices; ///< the soup's, but where slits were closed
    std::vector<std::uint32_t> order;      ///< welded vertices in the order of their first use
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> origins; ///< of each triangle, the file's that it is or is part of, or none
    std::vector<bool> isTurned;         ///< each triangle, against that one
    /// Of the file's triangles, in its own texture; empty where it has none at all.
    std::vector<std::optional<CornerCoordinates>> places;
    RepairReport report;
    LeftOpen left;
};

double extentOf(const PolygonSoup& soup) {
    return soup.vertices.empty() ? 0 : boundingBox(soup.vertices).sizes().maxCoeff();
}

/// Relative: what is lost where the widest slit is told in another unit of length and given back.
constexpr double conversionLoss = 1e-9;

void checkOpenings(std::vector<std::string>& problems, const PolygonSoup& soup,
                   const RepairOptions& options) {
    if (!(options.slitWidth >= 0))
        problems.emplace_back("the width of slits to close must be zero or more");
    else if (options.slitWidth > 0 && options.slitWidth > (1 + conversionLoss) * widestSlit(extentOf(soup)))
        problems.emplace_back("the width of slits to close must be at most a tenth of the surface's size");
    if (options.holeEdges > mostHoleEdges || (options.holeEdges > 0 && options.holeEdges < 3))
        problems.emplace_back("holes to fill must have from 3 to " + std::to_string(mostHoleEdges) +
                              " edges");
}

void check(const PolygonSoup& soup, const RepairOptions& options) {
    std::vector<std::string> problems;
    const std::size_t vertices = soup.vertices.size(), faces = soup.polygons.size();
    if (!(options.weldDistance >= 0) || !std::isfinite(options.weldDistance))
        problems.emplace_back("the weld distance must be zero or more");
    checkOpenings(problems, soup, options);
    if (vertices >= noIndex) problems.emplace_back("the mesh has more vertices than can be numbered");
    reportOffenders(problems, "mesh point", "with a coordinate that is not a number or is too large",
                    placesWhere(vertices, [&](std::size_t i) {
                        return !(soup.vertices[i].array().abs() <= largestCoordinate).all();
                    }));
    reportOffenders(problems, "face", "with other than 3 to " + std::to_string(mostCorners) + " corners",
                    placesWhere(faces, [&](std::size_t i) {
                        return soup.polygons[i].size() < 3 || soup.polygons[i].size() > mostCorners;
                    }));
    reportOffenders(problems, "face",
                    "that names a mesh point beyond the " + std::to_string(vertices) + " there are",
                    placesWhere(faces, [&](std::size_t i) {
                        const std::vector<std::uint32_t>& corners = soup.polygons[i];
                        return std::any_of(corners.begin(), corners.end(),
                                           [&](std::uint32_t vertex) { return vertex >= vertices; });
                    }));
    if (!problems.empty()) throw InvalidModel(std::move(problems));
}

/// A polygon's corners after welding, without corners that fell onto their predecessor.
std::vector<std::uint32_t> weldedCorners(const std::vector<std::uint32_t>& polygon,
                                         const std::vector<std::uint32_t>& representatives) {
    std::vector<std::uint32_t> corners;
    corners.reserve(polygon.size());
    for (const std::uint32_t vertex : polygon)
        if (corners.empty() || corners.back() != representatives[vertex])
            corners.push_back(representatives[vertex]);
    while (corners.size() > 1 && corners.front() == corners.back())
        corners.pop_back();
    return corners;
}

/// Where the corners of a triangle of a polygon lie in the file's own texture. A vertex that stands in the
/// polygon twice, as at the two sides of a slit, is taken for the first of them.
std::optional<CornerCoordinates> placesIn(const PolygonSoup& soup, std::size_t polygon,
                                          const Triangle& triangle,
                                          const std::vector<std::uint32_t>& representatives) {
    const std::vector<std::uint32_t>& corners = soup.polygons[polygon];
    const std::vector<Eigen::Vector2d>& places = soup.textureCoordinates[polygon];
    if (places.size() != corners.size()) return std::nullopt;
    CornerCoordinates found;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto corner = std::find_if(corners.begin(), corners.end(), [&](std::uint32_t vertex) {
            return representatives[vertex] == triangle[i];
        });
        found[i] = places[static_cast<std::size_t>(corner - corners.begin())];
    }
    return found;
}

bool hasEqualCorners(const Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

// Against the longest side, so that the size of the organ and its unit do not matter. 10⁻¹² is a height of a
// millionth of a millionth of that side, some thousands of roundings: what is thinner has a normal of noise.
bool hasNoArea(const std::vector<Eigen::Vector3d>& vertices, const Triangle& t) {
    const Eigen::Vector3d u = vertices[t[1]] - vertices[t[0]], v = vertices[t[2]] - vertices[t[0]];
    const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()});
    return u.cross(v).norm() <= 1e-12 * longest;
}

/// A polygon of n corners stands for n − 2 triangles. Each corner that falls onto its neighbour takes one of
/// them away, which is counted as a triangle without area.
void weldAndSplit(Workpiece& piece, double weldDistance, const Progress& progress) {
    const std::vector<std::uint32_t> representatives = weld(piece.soup.vertices, weldDistance);
    reportProgress(progress, 0.5);
    for (std::uint32_t i = 0; i < representatives.size(); ++i)
        piece.report.mergedVertices += representatives[i] != i;
    std::vector<bool> used(representatives.size(), false);
    const bool hasPlaces = !piece.soup.textureCoordinates.empty();
    for (std::size_t i = 0; i < piece.soup.polygons.size(); ++i) {
        const std::vector<std::uint32_t>& polygon = piece.soup.polygons[i];
        for (const std::uint32_t vertex : polygon) {
            const std::uint32_t welded = representatives[vertex];
            if (!used[welded]) piece.order.push_back(welded);
            used[welded] = true;
        }
        const std::vector<std::uint32_t> corners = weldedCorners(polygon, representatives);
        piece.report.splitPolygons += polygon.size() > 3;
        piece.report.degenerateTriangles += polygon.size() - std::max<std::size_t>(corners.size(), 2);
        if (corners.size() < 3) continue;
        for (const Triangle& triangle : splitPolygon(piece.soup.vertices, corners))
            if (hasEqualCorners(triangle)) {
                ++piece.report.degenerateTriangles;
            } else {
                piece.triangles.push_back(triangle);
                if (hasPlaces) piece.places.push_back(placesIn(piece.soup, i, triangle, representatives));
            }
    }
}

/// @return how many
std::size_t dropTriangles(Workpiece& piece, const std::vector<bool>& isDropped) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < isDropped.size(); ++i) {
        if (isDropped[i]) continue;
        if (!piece.places.empty()) piece.places[kept] = piece.places[i];
        piece.triangles[kept++] = piece.triangles[i];
    }
    piece.triangles.resize(kept);
    if (!piece.places.empty()) piece.places.resize(kept);
    return isDropped.size() - kept;
}

void dropDegenerate(Workpiece& piece) {
    std::vector<bool> isDegenerate;
    isDegenerate.reserve(piece.triangles.size());
    for (const Triangle& triangle : piece.triangles)
        isDegenerate.push_back(hasNoArea(piece.soup.vertices, triangle));
    piece.report.degenerateTriangles += dropTriangles(piece, isDegenerate);
}

// Triangles are alike by their corners in any order: two that face each other on the same corners would be a
// wall without thickness, whose springs are the same ones.
void dropDuplicate(Workpiece& piece) {
    std::vector<Triangle> sorted = piece.triangles;
    for (Triangle& triangle : sorted)
        std::sort(triangle.begin(), triangle.end());
    piece.report.duplicateTriangles = dropTriangles(piece, repeats(sorted));
}

std::size_t borderEdgeCount(const std::vector<Triangle>& triangles) {
    return countEdges(sidesByEdge(triangles)).boundary;
}

void dropDegenerateAndDuplicate(Workpiece& piece) {
    dropDegenerate(piece);
    dropDuplicate(piece);
    piece.origins.resize(piece.triangles.size());
    std::iota(piece.origins.begin(), piece.origins.end(), 0U);
    piece.isTurned.assign(piece.triangles.size(), false);
    if (piece.triangles.empty())
        throw InvalidModel("no triangle with an area remains of the mesh; export the surface again, or weld "
                           "points that are less far apart");
}

/// By the number of triangles: volume would ask for a closed surface, which a part need not be.
void selectParts(Workpiece& piece, KeepParts keep) {
    const Parts parts = connectedParts(piece.triangles, piece.soup.vertices.size());
    piece.report.components = parts.count;
    if (keep == KeepParts::All || parts.count == 1) return;
    std::vector<std::size_t> sizes(parts.count, 0);
    for (const std::uint32_t part : parts.ofTriangle)
        ++sizes[part];
    const auto largest =
        static_cast<std::size_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
    const std::size_t edges = borderEdgeCount(piece.triangles);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < piece.triangles.size(); ++i) {
        if (parts.ofTriangle[i] != largest) continue;
        piece.triangles[kept] = piece.triangles[i];
        piece.origins[kept] = piece.origins[i];
        piece.isTurned[kept++] = piece.isTurned[i];
    }
    piece.triangles.resize(kept);
    piece.origins.resize(kept);
    piece.isTurned.resize(kept);
    piece.report.droppedParts = parts.count - 1;
    piece.report.droppedPartEdges = edges - borderEdgeCount(piece.triangles);
    piece.report.components = 1;
}

void orient(Workpiece& piece) {
    const std::vector<bool> turned = orientTriangles(piece.vertices, piece.triangles);
    for (std::size_t i = 0; i < turned.size(); ++i)
        if (turned[i]) piece.isTurned[i] = !piece.isTurned[i];
}

/// What was turned twice is as it was, and the parts of a divided triangle are one.
std::size_t turnedTriangles(const Workpiece& piece) {
    std::vector<std::uint32_t> turned;
    for (std::size_t i = 0; i < piece.triangles.size(); ++i)
        if (piece.isTurned[i] && piece.origins[i] != noIndex) turned.push_back(piece.origins[i]);
    std::sort(turned.begin(), turned.end());
    return static_cast<std::size_t>(std::unique(turned.begin(), turned.end()) - turned.begin());
}

void closeWithin(Workpiece& piece, double width, const Progress& progress) {
    orient(piece);
    const ClosedSlits closed = closeSlits(piece.vertices, piece.triangles, width, progress);
    piece.report.closedSlitEdges = closed.edges;
    std::vector<std::uint32_t> origins;
    std::vector<bool> isTurned;
    origins.reserve(closed.origins.size());
    isTurned.reserve(closed.origins.size());
    for (const std::uint32_t former : closed.origins) {
        origins.push_back(former == noIndex ? noIndex : piece.origins[former]);
        isTurned.push_back(former != noIndex && piece.isTurned[former]);
    }
    piece.origins = std::move(origins);
    piece.isTurned = std::move(isTurned);
}

void fillSmallHoles(Workpiece& piece, std::size_t mostEdges, const Progress& progress) {
    std::vector<BorderLoop> holes = bordersOf(piece.triangles).loops;
    std::erase_if(holes, [&](const BorderLoop& loop) { return loop.size() > mostEdges; });
    const std::vector<bool> isFilled = fillHoles(piece.vertices, piece.triangles, holes, progress);
    for (std::size_t i = 0; i < holes.size(); ++i) {
        (isFilled[i] ? piece.report.filledHoles : piece.report.refusedHoles) += 1;
        (isFilled[i] ? piece.report.filledHoleEdges : piece.left.refusedEdges) += holes[i].size();
    }
    piece.origins.resize(piece.triangles.size(), noIndex);
    piece.isTurned.resize(piece.triangles.size(), false);
    orient(piece); // what was open may enclose a volume now, which has an outside
}

/// Slits first: where one is closed no hole is left, and two parts may be one.
void closeOpenings(Workpiece& piece, const RepairOptions& options, const Progress& progress) {
    ProgressParts parts(progress);
    if (options.slitWidth > 0) closeWithin(piece, options.slitWidth, parts.next(0.6));
    selectParts(piece, options.keep);
    reportProgress(parts.next(0.1), 1);
    orient(piece);
    if (options.holeEdges > 0) fillSmallHoles(piece, options.holeEdges, parts.rest());
}

std::size_t usedVertexCount(const Workpiece& piece) {
    std::vector<bool> used(piece.soup.vertices.size(), false);
    for (const Triangle& triangle : piece.triangles)
        for (const std::uint32_t vertex : triangle)
            used[vertex] = true;
    return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

/// A texture of its own is kept as a whole or not at all: one that knows no place of some triangles cannot be
/// painted there.
/// @return of each triangle; empty where any has none
std::vector<CornerCoordinates> keptPlaces(const Workpiece& piece, std::vector<std::string>& warnings) {
    if (piece.places.empty()) return {};
    std::vector<std::size_t> times(piece.places.size(), 0);
    for (const std::uint32_t origin : piece.origins)
        if (origin != noIndex) ++times[origin];
    std::vector<CornerCoordinates> kept;
    kept.reserve(piece.triangles.size());
    for (std::size_t i = 0; i < piece.triangles.size(); ++i) {
        const std::uint32_t origin = piece.origins[i];
        if (origin == noIndex || times[origin] > 1 || !piece.places[origin]) continue; // new, divided, bare
        kept.push_back(*piece.places[origin]);
        if (piece.isTurned[i]) std::swap(kept.back()[1], kept.back()[2]);
    }
    if (kept.size() == piece.triangles.size()) return kept;
    warnings.push_back("the texture coordinates of the file were dropped: " +
                       std::to_string(piece.triangles.size() - kept.size()) + " of " +
                       std::to_string(piece.triangles.size()) +
                       " triangles have none, in the file or since slits were closed or holes filled");
    return {};
}

/// Numbers the vertices that are left in the order in which the polygons first use them, corner by corner.
/// Numbers then hang on the faces alone: two files of one surface that list their points in another order
/// come to the same nodes.
TriangleMesh numbered(const Workpiece& piece) {
    std::vector<bool> used(piece.soup.vertices.size(), false);
    for (const Triangle& triangle : piece.triangles)
        for (const std::uint32_t vertex : triangle)
            used[vertex] = true;
    std::vector<std::uint32_t> numbers(piece.soup.vertices.size(), noIndex);
    TriangleMesh mesh;
    for (const std::uint32_t vertex : piece.order) {
        if (!used[vertex]) continue;
        numbers[vertex] = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(piece.vertices[vertex]);
    }
    mesh.triangles = piece.triangles;
    for (Triangle& triangle : mesh.triangles)
        for (std::uint32_t& vertex : triangle)
            vertex = numbers[vertex];
    return mesh;
}

} // namespace

// The order matters. Welding comes first, since without it no two triangles share an edge. Polygons are split
// after it, when corners that fell together are gone. Duplicates go before orientation: a triangle that is
// there twice makes each of its edges one of three or more, across which nothing can be oriented. Parts are
// chosen once no degenerate triangle joins two of them any more, and slits no longer part what is one.
RepairedMesh repair(const PolygonSoup& soup, const RepairOptions& options, const Progress& progress) {
    ProgressParts parts(progress);
    reportProgress(progress, 0);
    check(soup, options);
    Workpiece piece{soup, soup.vertices, {}, {}, {}, {}, {}, {}, {}};
    RepairReport& report = piece.report;
    weldAndSplit(piece, options.weldDistance, parts.next(0.3));

    const EdgeCounts before = countEdges(sidesByEdge(piece.triangles));
    reportProgress(parts.next(0.1), 1);
    report.boundaryEdgesBefore = before.boundary;
    report.nonManifoldEdgesBefore = before.nonManifold;
    dropDegenerateAndDuplicate(piece);
    report.unusedVertices = soup.vertices.size() - report.mergedVertices - usedVertexCount(piece);
    reportProgress(parts.next(0.15), 1);
    closeOpenings(piece, options, parts.next(0.3));

    const EdgeCounts after = countEdges(sidesByEdge(piece.triangles));
    reportProgress(parts.next(0.1), 1);
    report.boundaryEdges = after.boundary;
    report.nonManifoldEdges = after.nonManifold;
    report.inconsistentEdges = after.inconsistent;
    report.flippedTriangles = turnedTriangles(piece);
    if (after.boundary > 0) piece.left.looseEdges = bordersOf(piece.triangles).looseEdges;
    report.warnings = repairWarnings(report, piece.left);
    std::vector<CornerCoordinates> places = keptPlaces(piece, report.warnings);
    RepairedMesh mesh{numbered(piece), report};
    mesh.mesh.textureCoordinates = std::move(places);
    reportProgress(progress, 1);
    return mesh;
}

double widestSlit(double extent) {
    return extent / 10;
}

} // namespace esm
