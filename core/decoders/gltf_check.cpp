#include "core/decoders/gltf_address.h"
#include "core/decoders/mesh_file_checks.h"
#include "core/exchange/package/glb.h"
#include "core/support/errors.h"
#include "core/support/file_io.h"
#include "core/support/json_reader.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace esm {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

/// A node may place a mesh again in a few bytes, and a primitive share its points with others: what the
/// tables come to is bounded, so that a small file cannot fill the memory.
constexpr double mostTriangles = 1e7, mostVertices = 3e7;

/// What meshes take when they are read. Fractions never occur; sums cannot overflow.
struct MeshSize {
    double triangles = 0, vertices = 0;

    MeshSize& operator+=(const MeshSize& other) {
        triangles += other.triangles;
        vertices += other.vertices;
        return *this;
    }
};

/// Checks the tables of a glTF document against each other and against the data there is, so that nothing
/// hangs on the importer's own checks. Every number that leads to another place is followed first, and every
/// sum by which memory is taken is bounded.
class GltfChecker {
public:
    GltfChecker(const fs::path& file, Json document, std::optional<std::size_t> binaryBytes)
        : m_file(file), m_document(std::move(document)), m_binaryBytes(binaryBytes) {}

    void check() const {
        if (!m_document.is_object()) fail("has no JSON object at its top");
        checkRequiredExtensions();
        forEach("buffers", [this](const Json& buffer, std::size_t index) { checkBuffer(buffer, index); });
        forEach("bufferViews", [this](const Json& view, std::size_t index) { checkView(view, index); });
        forEach("accessors",
                [this](const Json& accessor, std::size_t index) { checkAccessor(accessor, index); });
        checkSizes();
    }

    std::size_t triangleCount() const {
        std::size_t triangles = 0;
        forEach("meshes", [&](const Json& mesh, std::size_t index) {
            for (const Json& primitive : mesh.value("primitives", Json::array()))
                triangles += trianglesOf(primitive, "mesh " + std::to_string(index));
        });
        return triangles;
    }

private:
    [[noreturn]] void fail(const std::string& problem) const {
        throw FileError(m_file, problem + "; export it again");
    }

    template<typename Check> void forEach(const char* table, const Check& check) const {
        if (!m_document.contains(table)) return;
        if (!m_document[table].is_array()) fail(std::string("has a \"") + table + "\" that is no list");
        for (std::size_t i = 0; i < m_document[table].size(); ++i)
            check(m_document[table][i], i);
    }

    std::size_t number(const Json& object, const char* key, std::size_t ifMissing) const {
        if (!object.is_object()) fail("has a table entry that is no object");
        const auto found = object.find(key);
        if (found == object.end()) return ifMissing;
        if (!found->is_number_unsigned()) fail(std::string("has a \"") + key + "\" that is no count");
        return found->get<std::size_t>();
    }

    const Json& entry(const char* table, std::size_t index, const std::string& user) const {
        if (!m_document.contains(table) || index >= m_document[table].size())
            fail(user + " names entry " + std::to_string(index) + " of \"" + table +
                 "\", which is not there");
        return m_document[table][index];
    }

    using Parents = std::vector<std::optional<std::size_t>>;

    std::size_t trianglesOf(const Json& primitive, const std::string& place) const;
    std::size_t verticesOf(const Json& primitive, const std::string& place) const;
    std::vector<MeshSize> meshSizes() const;
    Parents nodeParents() const;
    void checkRequiredExtensions() const;
    void checkSizes() const;
    void requireReadable(const MeshSize& size, const std::string& what) const;
    void checkBuffer(const Json& buffer, std::size_t index) const;
    void checkView(const Json& view, std::size_t index) const;
    void checkAccessor(const Json& accessor, std::size_t index) const;

    const fs::path& m_file;
    Json m_document;
    std::optional<std::size_t> m_binaryBytes; ///< of a GLB's binary chunk
};

void GltfChecker::checkRequiredExtensions() const {
    const Json required = m_document.value("extensionsRequired", Json::array());
    for (const char* compression : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"})
        for (const Json& name : required)
            if (name == compression)
                throw FileError(m_file, std::string("is compressed (") + compression +
                                            "), which cannot be read; export it without compression");
}

/// Nodes are trees, and not so deep that walking down them by recursion could run out of stack. With at most
/// one parent for each node a ring can only be found upwards, where it is a way longer than any that is
/// allowed.
GltfChecker::Parents GltfChecker::nodeParents() const {
    constexpr std::size_t deepest = 200;
    Parents parents(m_document.value("nodes", Json::array()).size());
    forEach("nodes", [&](const Json& node, std::size_t index) {
        if (!node.is_object()) fail("has a node that is no object");
        for (const Json& child : node.value("children", Json::array())) {
            if (!child.is_number_unsigned() || child.get<std::size_t>() >= parents.size())
                fail("has a node " + std::to_string(index) + " with a child that is not there");
            std::optional<std::size_t>& parent = parents[child.get<std::size_t>()];
            if (parent) fail("has a node " + child.dump() + " with two parents");
            parent = index;
        }
    });
    for (std::size_t node = 0; node < parents.size(); ++node) {
        std::size_t depth = 0;
        for (std::optional<std::size_t> parent = parents[node]; parent; parent = parents[*parent])
            if (++depth > deepest) fail("has nodes nested too deeply, or within themselves");
    }
    return parents;
}

std::vector<MeshSize> GltfChecker::meshSizes() const {
    std::vector<MeshSize> sizes;
    forEach("meshes", [&](const Json& mesh, std::size_t index) {
        const std::string place = "mesh " + std::to_string(index);
        MeshSize size;
        for (const Json& primitive : mesh.value("primitives", Json::array()))
            size += {static_cast<double>(trianglesOf(primitive, place)),
                     static_cast<double>(verticesOf(primitive, place))};
        sizes.push_back(size);
    });
    return sizes;
}

void GltfChecker::requireReadable(const MeshSize& size, const std::string& what) const {
    if (size.triangles <= mostTriangles && size.vertices <= mostVertices) return;
    fail(what + " more than the 10 million triangles or 30 million points that can be read; leave out copies "
                "or reduce the mesh");
}

/// A mesh is placed as often as a scene names its node or one above it. What a node brings is added to all
/// above it once, instead of walking down from each scene: trees of 200 levels at most, so that cost stays in
/// proportion to the nodes however often they are placed.
void GltfChecker::checkSizes() const {
    const Parents parents = nodeParents();
    const std::vector<MeshSize> meshes = meshSizes();
    MeshSize held;
    for (const MeshSize& mesh : meshes)
        held += mesh;
    requireReadable(held, "holds");
    std::vector<MeshSize> nodes(parents.size()); // with all below
    forEach("nodes", [&](const Json& node, std::size_t index) {
        const std::size_t mesh = number(node, "mesh", meshes.size());
        if (mesh >= meshes.size()) return;
        nodes[index] += meshes[mesh];
        for (std::optional<std::size_t> parent = parents[index]; parent; parent = parents[*parent])
            nodes[*parent] += meshes[mesh];
    });
    forEach("scenes", [&](const Json& scene, std::size_t index) {
        MeshSize placed;
        for (const Json& node : scene.value("nodes", Json::array()))
            if (node.is_number_unsigned() && node.get<std::size_t>() < nodes.size())
                placed += nodes[node.get<std::size_t>()];
        requireReadable(placed, "places in scene " + std::to_string(index));
    });
}

/// Of an address in base64 four letters hold three bytes.
void GltfChecker::checkBuffer(const Json& buffer, std::size_t index) const {
    const std::string place = "buffer " + std::to_string(index);
    const std::size_t announced = number(buffer, "byteLength", 0);
    const Json uri = buffer.value("uri", Json());
    std::size_t held = m_binaryBytes.value_or(0);
    if (uri.is_string()) {
        const std::string name = uri.get<std::string>();
        if (name.rfind("data:", 0) == 0) {
            held = (name.size() - std::min(name.size(), name.find(',') + 1)) / 4 * 3;
        } else {
            held = regularFileSize(fileAtAddress(m_file, name));
        }
    }
    if (announced > held)
        fail("is cut off: " + place + " announces " + std::to_string(announced) + " bytes and holds " +
             std::to_string(held));
}

/// Compared by subtraction: offset + length of a damaged file may wrap around.
void GltfChecker::checkView(const Json& view, std::size_t index) const {
    const std::string place = "buffer view " + std::to_string(index);
    const std::size_t whole = number(entry("buffers", number(view, "buffer", 0), place), "byteLength", 0);
    const std::size_t offset = number(view, "byteOffset", 0), length = number(view, "byteLength", 0);
    if (offset > whole || length > whole - offset) fail(place + " reaches beyond the end of its buffer");
}

std::size_t componentBytes(std::size_t componentType) {
    switch (componentType) {
    case 5120:
    case 5121:
        return 1; // byte, unsigned byte
    case 5122:
    case 5123:
        return 2; // short, unsigned short
    case 5125:
    case 5126:
        return 4; // unsigned int, float
    default:
        return 0;
    }
}

std::size_t componentCount(const std::string& type) {
    if (type == "SCALAR") return 1;
    if (type == "VEC2") return 2;
    if (type == "VEC3") return 3;
    if (type == "VEC4" || type == "MAT2") return 4;
    if (type == "MAT3") return 9;
    return type == "MAT4" ? 16 : 0;
}

void GltfChecker::checkAccessor(const Json& accessor, std::size_t index) const {
    const std::string place = "accessor " + std::to_string(index);
    const std::size_t count = number(accessor, "count", 0);
    if (!accessor.contains("bufferView")) {
        // Without data an accessor stands for zeros, as many as the file likes to say.
        if (static_cast<double>(count) > mostVertices)
            fail(place + " announces " + std::to_string(count) + " entries without any data");
        return;
    }
    const Json type = accessor.value("type", Json());
    const std::size_t elementBytes = componentBytes(number(accessor, "componentType", 0)) *
                                     componentCount(type.is_string() ? type.get<std::string>() : "");
    if (elementBytes == 0) fail(place + " has an unknown type");
    const Json& view = entry("bufferViews", number(accessor, "bufferView", 0), place);
    const std::size_t stride = std::max(number(view, "byteStride", elementBytes), elementBytes);
    const std::size_t offset = number(accessor, "byteOffset", 0), whole = number(view, "byteLength", 0);
    if (count == 0) return;
    if (offset > whole || whole - offset < elementBytes ||
        count - 1 > (whole - offset - elementBytes) / stride)
        fail(place + " announces " + std::to_string(count) + " entries, more than its data holds");
}

std::size_t GltfChecker::trianglesOf(const Json& primitive, const std::string& place) const {
    constexpr std::size_t separate = 4, fan = 6; // a strip between them
    const std::size_t mode = number(primitive, "mode", separate);
    const Json attributes = primitive.value("attributes", Json::object());
    if (mode < separate || mode > fan || !attributes.contains("POSITION")) return 0;
    const std::size_t accessor = number(primitive, "indices", number(attributes, "POSITION", 0));
    const std::size_t corners = number(entry("accessors", accessor, place), "count", 0);
    if (mode == separate) return corners / 3;
    return corners < 3 ? 0 : corners - 2;
}

/// Shapes that a mesh morphs into are points of their own.
std::size_t GltfChecker::verticesOf(const Json& primitive, const std::string& place) const {
    const Json attributes = primitive.value("attributes", Json::object());
    if (!attributes.contains("POSITION")) return 0;
    const std::size_t shapes = 1 + primitive.value("targets", Json::array()).size();
    return shapes * number(entry("accessors", number(attributes, "POSITION", 0), place), "count", 0);
}

/// Checks everything and counts the triangles. The guards of parseJson() come before the importer, which
/// parses without any.
std::size_t checkDocument(const fs::path& file, const char* begin, const char* end,
                          std::optional<std::size_t> binaryBytes) {
    try {
        const GltfChecker checker(file, parseJson(begin, end), binaryBytes);
        checker.check();
        return checker.triangleCount();
    } catch (const InvalidModel& error) {
        throw FileError(file, std::string("is damaged or cut off: its JSON part: ") + error.what() +
                                  "; export it again");
    } catch (const Json::exception&) {
        throw FileError(file, "is damaged: its JSON part is not in the form of glTF; export it again");
    }
}

GlbParts partsOf(const fs::path& file, const Bytes& content) {
    try {
        return glbParts(content);
    } catch (const InvalidModel& error) {
        throw FileError(file, error.what());
    }
}

} // namespace

std::size_t checkGltf(const fs::path& file, const Bytes& content) {
    const char* begin = reinterpret_cast<const char*>(content.data());
    return checkDocument(file, begin, begin + content.size(), std::nullopt);
}

std::size_t checkGlb(const fs::path& file, const Bytes& content) {
    const GlbParts parts = partsOf(file, content);
    return checkDocument(file, parts.json, parts.jsonEnd,
                         static_cast<std::size_t>(parts.binaryEnd - parts.binary));
}

} // namespace esm
