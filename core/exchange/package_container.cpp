#include "core/exchange/package_container.h"

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

/// What glTF lets a node be placed by, and the values that leave it where it is.
struct TransformKey {
    const char* name;
    Json identity;
};

const std::vector<TransformKey>& transformKeys() {
    static const std::vector<TransformKey> keys{{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}},
                                                {"translation", {0, 0, 0}},
                                                {"rotation", {0, 0, 0, 1}},
                                                {"scale", {1, 1, 1}}};
    return keys;
}

/// Nodes that show a mesh, or may have one beneath them.
bool placesMeshes(const Json& node) {
    return node.is_object() && (node.contains("mesh") || node.contains("children"));
}

template<class Check> void forEachOf(const Json& gltf, const char* list, const Check& check) {
    const auto found = gltf.find(list);
    if (found == gltf.end() || !found->is_array()) return;
    for (std::size_t i = 0; i < found->size(); ++i)
        check((*found)[i], std::string(list) + "[" + std::to_string(i) + "]");
}

} // namespace

std::vector<std::string> containerWarnings(const Json& gltf) {
    std::vector<std::string> warnings;
    forEachOf(gltf, "nodes", [&](const Json& node, const std::string& place) {
        if (!placesMeshes(node)) return;
        for (const TransformKey& key : transformKeys())
            if (node.contains(key.name) && node[key.name] != key.identity)
                warnings.push_back(place + " should have no " + key.name +
                                   ": the mesh is shown elsewhere than it is simulated");
    });
    for (const char* list : {"images", "buffers"})
        forEachOf(gltf, list, [&](const Json& holder, const std::string& place) {
            if (holder.is_object() && holder.contains("uri"))
                warnings.push_back(place + " should have no uri: nothing of a package lies outside its file");
        });
    return warnings;
}

} // namespace esm
