#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/support/progress.h"
#include "core/texture/projection/projector.h"

#include <cstdint>
#include <vector>

namespace esm {

/// That a thread looks at before it takes others.
constexpr std::size_t trianglesPerBlock = 512;

/// What is certain of a triangle without following any ray.
enum class Lighting : std::uint8_t {
    Unknown,
    Lit,    ///< nothing hides any point of it from the projector
    Hidden, ///< something hides every point of it
};

/// The surface that light falls on.
struct ShadowCaster {
    const TriangleMesh& mesh;
    const std::vector<Triangle>& across; ///< as `trianglesAcross` gives it
    double tolerance;                    ///< m, how far surface may lie before another without hiding it
};

/// How far surface may lie before another without hiding it, m.
double hidingTolerance(const TriangleMesh& mesh);

/// Light that surface keeps from what lies so far behind it (m): none within the tolerance, all from twenty
/// times that, smoothly between, so that shallow folds of a rough surface leave no cracks in a photo.
double hiddenShare(double behind, double tolerance);

/// What is certain of each triangle that the photo's light meets. Their views in the photo's plane are
/// compared: a triangle is lit when all whose views overlap its own lie behind it, and hidden when triangles
/// before it that hang together cover its view without an end or a fold there. Nothing is said of those that
/// reach behind a perspective projector's eye, and of those far outside the photo.
/// @throws Cancelled
std::vector<Lighting> certainLighting(const ShadowCaster& surface, const Projector& projector,
                                      PhotoSize photo, const Progress& progress = {});

} // namespace esm
