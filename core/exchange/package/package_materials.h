#pragma once

#include "core/exchange/package/page_vertices.h"
#include "core/support/json_reader.h"
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

/// Of every vertex that is drawn of a page: in which direction on the surface its normal map's x points, the
/// mean of the triangles that share it, of length 1 and at right angles to the vertex's normal, and the side
/// on which y is, 1 or −1, as glTF has it.
/// @param triangles of the page
std::vector<float> vertexTangents(const TriangleMesh& mesh, const Atlas& atlas, const PageVertices& drawn,
                                  const std::vector<std::uint32_t>& triangles);

} // namespace esm
