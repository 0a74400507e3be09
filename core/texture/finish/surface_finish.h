#pragma once

#include "core/support/fields.h"

#include <array>
#include <string>
#include <vector>

namespace esm {

/// How a surface shines, whatever its colour: tissue of some roughness, of which a part lies under a film of
/// fluid. It is what glTF 2.0 calls a rough dielectric under a clear coat (`KHR_materials_clearcoat`).
struct SurfaceFinish {
    double roughness = 0.6; ///< of the tissue, 0 mirrors to 1 dull: glTF's, the square root of GGX's α
    double wetness = 0;     ///< the part that the film covers, 0 to 1

    bool operator==(const SurfaceFinish&) const = default;
};
template<>
inline constexpr auto fieldsOf<SurfaceFinish> =
    fieldTable(field("roughness", &SurfaceFinish::roughness, Limits<double>{"the roughness", 0, 1}),
               field("wetness", &SurfaceFinish::wetness, Limits<double>{"the wetness", 0, 1}));

/// GGX's roughness of the film, as glTF has it: fluid is smooth, and not quite still.
constexpr double filmRoughness = 0.12;

constexpr double deepestRelief = 0.005;   ///< m
constexpr double farthestOcclusion = 0.1; ///< m, reach of ambient occlusion: beyond it no organ has folds

/// What a layer lends to the surface that it covers.
struct LayerFinish {
    SurfaceFinish surface;
    /// How much wetter it is where its photo has highlights: 0 not at all, 1 there the film covers all.
    double wetAtHighlights = 0;
    /// m, how high a spot stands that is half as bright again as its surroundings in the photo. That bright
    /// is high is a guess: a photo does not tell form from colour.
    double relief = 0;
    bool hidesColour = false; ///< the layer shows nothing but its finish

    bool operator==(const LayerFinish&) const = default;
};
template<>
inline constexpr auto fieldsOf<LayerFinish> = fieldTable(
    fieldsOfMember(&LayerFinish::surface),
    field("wetAtHighlights", &LayerFinish::wetAtHighlights, Limits<double>{"the wetness at highlights", 0, 1})
        .whenSet(),
    field("relief", &LayerFinish::relief, Limits<double>{"the relief", 0, deepestRelief, "m"}).whenSet(),
    field("hidesColour", &LayerFinish::hidesColour).whenSet());

/// Every problem of a finish. Empty when all is well.
std::vector<std::string> validate(const LayerFinish& finish);

/// A kind of tissue as it is seen through an endoscope. The numbers are estimates by eye; nobody measured
/// them.
struct FinishPreset {
    const char* word; ///< as the command line has it
    const char* name; ///< for people
    SurfaceFinish surface;
};
inline constexpr std::array<FinishPreset, 7> finishPresets{
    FinishPreset{"dry", "Dry", {0.6, 0}},         FinishPreset{"serosa", "Serosa", {0.35, 0.8}},
    FinishPreset{"mucosa", "Mucosa", {0.45, 1}},  FinishPreset{"liver-capsule", "Liver capsule", {0.3, 0.7}},
    FinishPreset{"fat", "Fat", {0.5, 0.55}},      FinishPreset{"muscle", "Muscle", {0.55, 0.45}},
    FinishPreset{"charred", "Charred", {0.95, 0}}};

} // namespace esm
