#pragma once

#include "core/project/project.h"
#include "core/surface/surface_query.h"

#include <string>

namespace esm {

/// The sample organs one by one; makeSample() chooses.
Project makeTube();
Project makeUterus();
Project makeVentricle();
Project makeLiver();

/// A surface made by code as an import would report it; its vertices keep their numbers.
RepairedMesh asImported(TriangleMesh mesh);

/// A region over the whole organ, or one without an ellipsoid yet, with a shipped fuzzy system.
Region fuzzyRegion(std::string name, const std::string& preset, NamedValues inputs);

/// An instrument that comes along a ray, pushes the surface in by `depth`, stays and is gone at half time.
/// @throws InvalidModel when the ray misses the surface
struct Poke {
    Ray ray;
    double radius;   ///< m, of the instrument
    double depth;    ///< m
    double duration; ///< s, of the whole
};
InstrumentMotion pokeOf(const TriangleMesh& mesh, const Poke& poke);

} // namespace esm
