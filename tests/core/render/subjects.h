#pragma once

#include "core/render/renderer.h"

namespace esm {

/// A closed unit ball pressed into an organ-like shape by `bump` (0: a sphere).
TriangleMesh ball(int rings, int sectors, double bump = 0);
/// Two triangles, 1 m wide and high, facing +z, with an atlas that lays one square picture over both.
RenderScene texturedSquare(const Image& picture);
/// A picture of four plain colours in quarters: red, green, blue, grey from the top left.
Image quarters(int size);
/// Springs and nodes for a mesh: every edge a spring.
std::shared_ptr<const SpringNetwork> edgeNetwork(const TriangleMesh& mesh);

} // namespace esm
