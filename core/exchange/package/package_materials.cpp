#include "core/exchange/package/package_materials.h"

#include <cmath>

namespace esm {

namespace {

using Json = nlohmann::ordered_json;

constexpr double usualRoughness = 0.6; ///< of packages without a finish

/// glTF's colour factors are linear light, the project's colour is sRGB.
double linearLight(std::uint8_t channel) {
    const double value = channel / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

Json texture(std::size_t place) {
    return {{"index", place}};
}

} // namespace

Json textureOf(const Atlas& atlas) {
    Json json{{"size", atlas.options.size},
              {"gap", atlas.options.layout == AtlasLayout::Own ? 0 : atlas.options.gap}, // nobody kept one
              {"texelsPerMetre", atlas.texelsPerMetre},
              {"utilisation", atlas.utilisation}};
    if (isStretched(atlas.options.layout)) json["layout"] = wordOf(atlas.options.layout);
    return json;
}

/// A viewer that does not know the extension shows the tissue under the film, which shines by its own
/// roughness. The film itself has no normal map: fluid lies smooth over what is rough.
Json materialOf(const MaterialTextures& textures, const std::array<std::uint8_t, 3>& colour,
                const std::optional<SurfaceFinish>& finish) {
    const bool isPainted = textures.wetnessAndRoughness.has_value();
    Json surface{{"metallicFactor", 0},
                 {"roughnessFactor", isPainted ? 1.0
                                     : finish  ? finish->roughness
                                               : usualRoughness}};
    if (textures.colour)
        surface["baseColorTexture"] = texture(*textures.colour);
    else
        surface["baseColorFactor"] = {linearLight(colour[0]), linearLight(colour[1]), linearLight(colour[2]),
                                      1.0};
    if (isPainted) surface["metallicRoughnessTexture"] = texture(*textures.wetnessAndRoughness);
    Json material{{"pbrMetallicRoughness", std::move(surface)}, {"doubleSided", true}};
    if (textures.normals) material["normalTexture"] = texture(*textures.normals);
    if (textures.occlusion) material["occlusionTexture"] = texture(*textures.occlusion);
    if (!isPainted && !finish) return material;
    Json coat{{"clearcoatFactor", isPainted ? 1.0 : finish->wetness},
              {"clearcoatRoughnessFactor", filmRoughness}};
    if (isPainted) coat["clearcoatTexture"] = texture(*textures.wetnessAndRoughness);
    material["extensions"][clearcoatExtension] = std::move(coat);
    return material;
}

} // namespace esm
