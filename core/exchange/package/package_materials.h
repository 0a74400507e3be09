#pragma once

#include "core/support/json_reader.h"
#include "core/texture/atlas/atlas.h"
#include "core/texture/finish/surface_finish.h"

#include <optional>
#include <vector>

namespace esm {

/// glTF's extension for the film of fluid on the surface.
constexpr const char* clearcoatExtension = "KHR_materials_clearcoat";

/// What the package's extension says of the texture's pages.
nlohmann::ordered_json textureOf(const Atlas& atlas);

/// Places of a page's pictures among the file's textures.
struct MaterialTextures {
    std::optional<std::size_t> colour, wetnessAndRoughness, normals, occlusion;
};

/// A material of glTF, seen from both sides.
/// @param colour of what has no picture of colours, sRGB
/// @param finish of what has no picture of it; none: tissue as packages have always shown it
nlohmann::ordered_json materialOf(const MaterialTextures& textures, const std::array<std::uint8_t, 3>& colour,
                                  const std::optional<SurfaceFinish>& finish);

} // namespace esm
