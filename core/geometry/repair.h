#pragma once

#include "core/geometry/polygon_soup.h"
#include "core/geometry/repair_report.h"
#include "core/geometry/triangle_mesh.h"
#include "core/support/progress.h"

#include <cstddef>

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

struct RepairedMesh {
    TriangleMesh mesh; ///< vertices in the order in which the polygons first use them, corner by corner
    RepairReport report;
};

/// Makes a triangle mesh that can carry springs of a soup of polygons: welds equal vertices, splits polygons,
/// drops degenerate and duplicate triangles and unused vertices, makes neighbouring triangles agree in
/// orientation and closed parts face outwards. Slits are closed and holes filled where that is asked for; all
/// other open borders, and non-manifold edges, are kept and counted. A part is what hangs together once slits
/// are closed. Places in a texture of the soup's own go with their triangles; where one is left without, all
/// are dropped with a warning.
/// @throws InvalidModel with every coordinate that is not finite or beyond 10¹² and every face that names a
/// missing vertex or has too few or too many corners; with options beyond their limits; or when no triangle
/// remains
/// @throws Cancelled
RepairedMesh repair(const PolygonSoup& soup, const RepairOptions& options = {},
                    const Progress& progress = {});

/// Of a surface of this extent, the largest side of the box around it: what lies farther apart is no slit.
double widestSlit(double extent);

} // namespace esm
