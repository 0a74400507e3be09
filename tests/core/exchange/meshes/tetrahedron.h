#pragma once

#include "core/geometry/triangle_mesh.h"

#include <nlohmann/json.hpp>

#include <cstring>
#include <string>
#include <vector>

namespace esm::tetrahedron {

/// A tetrahedron of side lengths around 1 and volume 1/6, in every format.
inline const std::vector<Eigen::Vector3f> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
inline const std::vector<Triangle> faces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};

template<typename Number> void put(std::string& bytes, Number value, bool bigEndian = false) {
    std::string raw(sizeof value, '\0');
    std::memcpy(raw.data(), &value, sizeof value);
    bytes += bigEndian ? std::string(raw.rbegin(), raw.rend()) : raw;
}

inline std::string meshBuffer() {
    std::string bytes;
    for (const Eigen::Vector3f& corner : corners)
        for (const float coordinate : corner)
            put(bytes, coordinate);
    for (const Triangle& t : faces)
        for (const std::uint32_t v : t)
            put(bytes, static_cast<std::uint16_t>(v));
    return bytes;
}

inline nlohmann::json gltfDocument() {
    return nlohmann::json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": 72}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0],
                       "max": [1, 1, 1]},
                      {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}]})");
}

inline std::string glb(std::string json, const std::string& buffer = meshBuffer()) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string bytes = "glTF";
    put(bytes, std::uint32_t{2});
    put(bytes, static_cast<std::uint32_t>(28 + json.size() + buffer.size()));
    put(bytes, static_cast<std::uint32_t>(json.size()));
    bytes += "JSON" + json;
    put(bytes, static_cast<std::uint32_t>(buffer.size()));
    return bytes + std::string("BIN\0", 4) + buffer;
}

inline std::string glb(const nlohmann::json& document, const std::string& buffer = meshBuffer()) {
    return glb(document.dump(), buffer);
}

} // namespace esm::tetrahedron
