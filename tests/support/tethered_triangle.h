#pragma once

#include "core/dynamics/contact/touched_surface.h"
#include "tests/support/tissue_models.h"

/// What has an analytic answer to a finger: a triangle that moves as one piece against three tethers.
namespace esm::test {

constexpr double tetherConstant = 20, tetherViscosity = 5; ///< N/m, N·s/m, of each

/// In the plane z = 0, facing +z, its middle at the origin; next to no mass.
inline TriangleMesh largeTriangle() {
    return {{{0.1, 0, 0}, {-0.05, 0.0866, 0}, {-0.05, -0.0866, 0}}, {{0, 1, 2}}};
}

inline TissueModel tetheredTriangle() {
    TissueModel model = tissue::fromMesh(largeTriangle(), {10, 0.1, 1e-6});
    for (std::uint32_t node = 0; node < 3; ++node)
        model.tethers.push_back({node, tetherConstant, tetherViscosity});
    return model;
}

} // namespace esm::test
