#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/texture/layers/composite.h"
#include "core/texture/maps/finish_layers.h"

#include <array>

namespace esm {

/// What every texel's pixel means in a page of the finish: red is the wetness, green the roughness, 0 to 1;
/// blue and alpha are x and y of the normal in the tangent space of its patch (PatchFrame), from −1 through
/// 128 for 0 to 1.
constexpr std::uint8_t noTilt = 128;

/// A surface's finish, and what it was made of.
struct FinishComposition {
    Composition composed;                    ///< of the finish's layers
    double greatestHeight = 0;               ///< m
    std::shared_ptr<const TiledPages> pages; ///< null before anything was composed
};

/// Composes the finish as composite() composes colours, and turns its heights into normals. Only what has
/// changed since `before` is made anew; with nothing before, all is.
/// @param layers of the finish, see finishLayers()
/// @throws InvalidModel for a layout of another surface or beyond its pages; Cancelled
FinishComposition composedFinish(const TriangleMesh& mesh, const Atlas& atlas,
                                 const FinishComposition& before, const FinishLayers& layers,
                                 CompositionCache& cache, const Progress& progress = {});

/// The pages of a whole surface, made at once. Null where no layer lends a finish: then it is `base`
/// everywhere.
/// @throws InvalidModel as composedFinish(), Cancelled
std::shared_ptr<const TiledPages> finishPages(const TriangleMesh& mesh, const Atlas& atlas,
                                              const std::vector<TextureLayer>& layers,
                                              const std::optional<SurfaceFinish>& base,
                                              const Progress& progress = {});

/// What glTF reads of a page of the finish.
struct MaterialPage {
    Image wetnessAndRoughness; ///< red: clearcoat; green: roughness; blue: metal, of which there is none
    Image normals;             ///< of its tangent space; empty of a surface without relief
};
MaterialPage materialPage(const TiledImage& finish);

/// The page of the finish that comes to such a material. Precondition: pictures of one size.
TiledImage finishPage(const MaterialPage& material);

} // namespace esm
