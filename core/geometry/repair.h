#pragma once

#include "core/geometry/polygon_soup.h"
#include "core/geometry/triangle_mesh.h"
#include "core/support/fields.h"
#include "core/support/progress.h"

#include <cstddef>
#include <string>
#include <vector>

namespace esm {

enum class KeepParts { All, Largest };

struct RepairOptions {
    /// Vertices no farther apart than this become one; 0 welds exactly equal ones. Unit of the soup.
    double weldDistance = 0;
    KeepParts keep = KeepParts::All; ///< `Largest`: the connected part with the most triangles
    /// Borders no farther apart than this are stitched (`closeSlits()`); 0 stitches none. Unit of the soup,
    /// at most `widestSlit()`.
    double slitWidth = 0;
    /// Open borders of at most so many edges are filled (`fillHoles()`); 0 fills none, else 3 to
    /// `mostHoleEdges`.
    std::size_t holeEdges = 0;

    bool operator==(const RepairOptions&) const = default;
};

/// What repair found and did. Counts named "before" are taken after welding and before duplicates are
/// dropped.
struct RepairReport {
    std::size_t mergedVertices = 0;
    std::size_t splitPolygons = 0;       ///< polygons of more than three corners
    std::size_t degenerateTriangles = 0; ///< dropped: two equal corners or no area
    std::size_t duplicateTriangles = 0;  ///< dropped: the same three corners in any order
    std::size_t unusedVertices = 0;      ///< dropped
    std::size_t flippedTriangles = 0;    ///< turned to agree with their neighbours or to face outwards
    std::size_t closedSlitEdges = 0;     ///< border edges that stitching joined
    std::size_t filledHoles = 0;
    std::size_t droppedParts = 0; ///< by `KeepParts::Largest`
    std::size_t components = 0;   ///< connected parts that were kept
    std::size_t boundaryEdgesBefore = 0, nonManifoldEdgesBefore = 0;
    std::size_t boundaryEdges = 0,
                nonManifoldEdges = 0;  ///< of the result: one triangle, more than two triangles
    std::size_t inconsistentEdges = 0; ///< between two triangles that cannot agree, as on a Möbius strip
    std::vector<std::string> warnings; ///< for people: what was repaired and what remains

    std::size_t removedTriangles() const { return degenerateTriangles + duplicateTriangles; }
    /// Whether the mesh encloses a volume: no border, and an inside and an outside everywhere.
    bool isClosed() const { return boundaryEdges + inconsistentEdges == 0; }
};
template<>
inline constexpr auto fieldsOf<RepairReport> =
    std::tuple{field("mergedVertices", &RepairReport::mergedVertices),
               field("splitPolygons", &RepairReport::splitPolygons),
               field("degenerateTriangles", &RepairReport::degenerateTriangles),
               field("duplicateTriangles", &RepairReport::duplicateTriangles),
               field("unusedVertices", &RepairReport::unusedVertices),
               field("flippedTriangles", &RepairReport::flippedTriangles),
               field("droppedParts", &RepairReport::droppedParts),
               field("components", &RepairReport::components),
               field("boundaryEdgesBefore", &RepairReport::boundaryEdgesBefore),
               field("nonManifoldEdgesBefore", &RepairReport::nonManifoldEdgesBefore),
               field("boundaryEdges", &RepairReport::boundaryEdges),
               field("nonManifoldEdges", &RepairReport::nonManifoldEdges),
               field("inconsistentEdges", &RepairReport::inconsistentEdges),
               field("warnings", &RepairReport::warnings),
               field("closedSlitEdges", &RepairReport::closedSlitEdges).whenSet(),
               field("filledHoles", &RepairReport::filledHoles).whenSet()};

struct RepairedMesh {
    TriangleMesh mesh; ///< vertices in the order in which the polygons first use them, corner by corner
    RepairReport report;
};

/// Makes a triangle mesh that can carry springs of a soup of polygons: welds equal vertices, splits polygons,
/// drops degenerate and duplicate triangles and unused vertices, makes neighbouring triangles agree in
/// orientation and closed parts face outwards. Slits are closed and holes filled where that is asked for; all
/// other open borders, and non-manifold edges, are kept and counted. A part is what hangs together once slits
/// are closed.
/// @throws InvalidModel with every coordinate that is not finite or beyond 10¹² and every face that names a
/// missing vertex or has too few or too many corners; with options beyond their limits; or when no triangle
/// remains
/// @throws Cancelled
RepairedMesh repair(const PolygonSoup& soup, const RepairOptions& options = {},
                    const Progress& progress = {});

/// Of a surface of this extent, the largest side of the box around it: what lies farther apart is no slit.
double widestSlit(double extent);

} // namespace esm
