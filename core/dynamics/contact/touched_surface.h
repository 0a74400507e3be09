#pragma once

#include "core/model/spring_network.h"

namespace esm {

/// What an instrument touches: triangles over the nodes, or a body that moves as one piece with the line
/// between two nodes.
struct TouchedSurface {
    struct Body {
        std::vector<Eigen::Vector3d> points; ///< m, at rest
        Edge line;                           ///< the nodes that move it
        Eigen::Vector3d first, second;       ///< m, the line's ends at rest
    };

    TouchedSurface() = default;
    /// Most surfaces are made of nodes.
    TouchedSurface(std::vector<Triangle> overNodes) : triangles(std::move(overNodes)) {}

    std::vector<Triangle> triangles; ///< over the nodes, or over the body's points
    std::optional<Body> body;

    bool empty() const { return triangles.empty(); }
};

/// The simulated surface under a drawn mesh; the whole drawn mesh where it moves as one piece.
TouchedSurface touchedSurface(const TriangleMesh& mesh, const SpringNetwork& network);

} // namespace esm
