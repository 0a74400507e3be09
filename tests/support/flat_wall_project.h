#pragma once

#include "core/samples/organs.h"

namespace esm {

/// A piece of a plane, tethered, whose wall resists bending.
inline Project flatWallProject() {
    TriangleMesh mesh;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 5; ++x)
            mesh.vertices.emplace_back(0.01 * x, 0.011 * y + 0.001 * x, 0.004 * x);
    for (std::uint32_t y = 0; y < 3; ++y)
        for (std::uint32_t x = 0; x < 4; ++x) {
            const std::uint32_t node = 5 * y + x;
            mesh.triangles.push_back({node, node + 1, node + 6});
            mesh.triangles.push_back({node, node + 6, node + 5});
        }
    Project project = makeProject("wall", asImported(mesh));
    project.base.resistsBending = true;
    return project;
}

} // namespace esm
