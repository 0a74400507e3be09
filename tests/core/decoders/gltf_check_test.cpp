#include "core/decoders/mesh_decoder.h"
#include "core/decoders/mesh_file_checks.h"
#include "core/support/errors.h"
#include "tests/core/exchange/meshes/tetrahedron.h"
#include "tests/core/exchange/overwrite.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

using testing::HasSubstr;
using tetrahedron::gltfDocument;
using GltfJson = nlohmann::json;

std::string gltfError(const std::string& name, const std::string& content) {
    const TemporaryFolder folder;
    overwrite(folder / name, content);
    try {
        decodeMesh(folder / name);
    } catch (const FileError& error) {
        return error.what();
    }
    return "no error";
}

/// The tetrahedron's points with a list of 10000 triangles.
GltfJson manyTriangles() {
    GltfJson document = gltfDocument();
    document["accessors"][1]["count"] = 30000;
    document["bufferViews"][1]["byteLength"] = 60000;
    document["buffers"][0]["byteLength"] = 60048;
    return document;
}

std::string glbOf(const GltfJson& document) {
    std::string buffer = tetrahedron::meshBuffer().substr(0, 48);
    for (int i = 0; i < 30000; ++i)
        tetrahedron::put(buffer, static_cast<std::uint16_t>(i % 3));
    return tetrahedron::glb(document, buffer);
}

TEST(GltfCheck, CountsTheTriangles) {
    const auto counted = [](const std::string& file) {
        return checkGlb("a.glb", Bytes(file.begin(), file.end()));
    };
    EXPECT_EQ(counted(tetrahedron::glb(gltfDocument())), 4U);
    EXPECT_EQ(counted(glbOf(manyTriangles())), 10000U);
}

TEST(GltfCheck, RefusesNodesNestedTooDeeply) {
    GltfJson document = gltfDocument(), nodes = GltfJson::array();
    for (int i = 0; i < 200000; ++i)
        nodes.push_back({{"children", {i + 1}}});
    nodes.push_back({{"mesh", 0}});
    document["nodes"] = nodes;
    EXPECT_THAT(gltfError("deep.glb", tetrahedron::glb(document)), HasSubstr("nested"));
}

TEST(GltfCheck, RefusesListsNestedBeyondAllUse) {
    std::string json = gltfDocument().dump();
    json.insert(1, "\"extras\":" + std::string(300000, '[') + std::string(300000, ']') + ",");
    EXPECT_THAT(gltfError("deep.glb", tetrahedron::glb(json)), HasSubstr("nested"));
    EXPECT_THAT(gltfError("deep.gltf", json), HasSubstr("nested"));
}

TEST(GltfCheck, RefusesCopiesThatWouldFillTheMemory) {
    GltfJson document = manyTriangles(), roots = GltfJson::array();
    EXPECT_EQ(gltfError("once.glb", glbOf(document)), "no error");
    for (int i = 0; i < 1001; ++i) {
        document["nodes"][static_cast<std::size_t>(i)] = {{"mesh", 0}};
        roots.push_back(i);
    }
    document["scenes"][0]["nodes"] = roots;
    EXPECT_THAT(gltfError("placed.glb", glbOf(document)), HasSubstr("10 million triangles"));

    document = manyTriangles();
    document["scenes"][0]["nodes"] = std::vector<int>(1001, 0);
    EXPECT_THAT(gltfError("listed.glb", glbOf(document)), HasSubstr("10 million triangles"));

    document = manyTriangles();
    GltfJson& primitives = document["meshes"][0]["primitives"];
    primitives = std::vector<GltfJson>(1001, primitives[0]);
    EXPECT_THAT(gltfError("shared.glb", glbOf(document)), HasSubstr("10 million triangles"));

    document = manyTriangles();
    document["accessors"][0] = {{"componentType", 5126}, {"type", "VEC3"}, {"count", 20'000'000}};
    document["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
    EXPECT_THAT(gltfError("morphed.glb", glbOf(document)), HasSubstr("30 million points"));
}

} // namespace
} // namespace esm
