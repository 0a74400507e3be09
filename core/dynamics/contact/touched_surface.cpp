#include "core/dynamics/contact/touched_surface.h"

namespace esm {

// What hangs on a line alone has no triangles over nodes: its drawn triangles are touched.
TouchedSurface touchedSurface(const TriangleMesh& mesh, const SpringNetwork& network) {
    if (!network.binding || !isOnOneLine(*network.binding)) return simulatedSurface(mesh, network);
    const Edge line = network.binding->lines.front();
    TouchedSurface surface(mesh.triangles);
    surface.body = TouchedSurface::Body{mesh.vertices, line, network.restPositions[line.first],
                                        network.restPositions[line.second]};
    return surface;
}

} // namespace esm
