#include "core/exchange/package/package_container.h"

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

/// A whole number of a JSON that cannot be trusted, 0 where there is none.
std::uint64_t unsignedMember(const Json& holder, const char* key) {
    const auto found = holder.is_object() ? holder.find(key) : holder.end();
    return found != holder.end() && found->is_number_unsigned() ? found->get<std::uint64_t>() : 0;
}

using Warnings = std::vector<std::string>;

/// Viewers that go by the buffer's own length refuse views beyond it, or the whole file.
void checkBuffer(const Glb& glb, Warnings& warnings) {
    const auto buffers = glb.json.find("buffers");
    if (buffers == glb.json.end() || !buffers->is_array() || buffers->empty()) {
        warnings.emplace_back("buffers should name the file's binary data");
        return;
    }
    const std::uint64_t length = unsignedMember(buffers->front(), "byteLength");
    if (length > glb.binary.size() || glb.binary.size() - length > 3) {
        warnings.push_back("buffers[0] should have the byteLength " + std::to_string(glb.binary.size()) +
                           ", that of the file's binary data");
        return;
    }
    forEachOf(glb.json, "bufferViews", [&](const Json& view, const std::string& place) {
        const std::uint64_t begin = unsignedMember(view, "byteOffset");
        if (begin > length || unsignedMember(view, "byteLength") > length - begin)
            warnings.push_back(place + " reaches beyond the byteLength of buffers[0]");
    });
}

void checkRequiredExtensions(const Json& gltf, Warnings& warnings) {
    forEachOf(gltf, "extensionsRequired", [&](const Json& name, const std::string& place) {
        if (name.is_string())
            warnings.push_back(place + " should not name " + name.get<std::string>() +
                               ": programs that do not know it refuse the file");
    });
}

} // namespace

std::vector<std::string> containerWarnings(const Glb& glb) {
    const Json& gltf = glb.json;
    Warnings warnings;
    checkBuffer(glb, warnings);
    checkRequiredExtensions(gltf, warnings);
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
