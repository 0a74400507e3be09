#pragma once

#include "core/dynamics/loads.h"
#include "tests/support/tissue_models.h"

namespace tissue {

/// What a ball is filled with.
struct Fluid {
    double stiffness = 0;       ///< Pa
    double largestPressure = 0; ///< Pa
};

/// A closed surface, filled: its first part.
inline TissueModel filled(const esm::TriangleMesh& mesh, const Parameters& parameters, const Fluid& fluid) {
    TissueModel model = fromMesh(mesh, parameters);
    esm::Cavity cavity = esm::cavityOf(mesh.vertices, mesh.triangles, 0);
    cavity.stiffness = fluid.stiffness;
    cavity.largestPressure = fluid.largestPressure;
    model.cavities = {std::move(cavity)};
    return model;
}

inline constexpr double ballRadius = 0.03; ///< m

inline TissueModel filledBall(int levels, const Parameters& parameters, const Fluid& fluid) {
    return filled(sphereMesh(levels, ballRadius), parameters, fluid);
}

/// Pa, that a ball of an even net bears at most: at twice its width, √3·c·(1 − 1/λ) = p·λ·r/2.
inline double mostPressure(double springConstant) {
    return std::sqrt(3.0) * springConstant / (2 * ballRadius);
}
/// How wide it becomes, times its width at rest, under a share of that: the lesser root of the same.
inline double widthUnder(double share) {
    return 2 / (1 + std::sqrt(1 - share));
}

/// A load that presses alike on the first part, Pa.
inline esm::Loads pressing(double pressure) {
    esm::Loads loads;
    loads.pressures = {{0, pressure, pressure}};
    return loads;
}

/// m³, that the model's first cavity encloses at these places.
inline double volumeOf(const TissueModel& model, const Vectors& positions) {
    return esm::enclosedVolume({positions, model.cavities.front().triangles});
}

} // namespace tissue
