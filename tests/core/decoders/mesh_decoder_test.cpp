#include "core/decoders/mesh_decoder.h"

#include "core/exchange/meshes/mesh_file.h"
#include "core/geometry/repair.h"
#include "core/support/errors.h"
#include "tests/core/exchange/meshes/tetrahedron.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
#include <sstream>

namespace esm {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using tetrahedron::corners;
using tetrahedron::faces;
using tetrahedron::glb;
using tetrahedron::gltfDocument;
using tetrahedron::meshBuffer;
using tetrahedron::put;

std::string objText() {
    return "# tetrahedron\nmtllib missing.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\ng side\nusemtl "
           "red\n"
           "f 1/1/1 3/1/1 2/1/1\nv 0 0 1\nusemtl blue\nf 1//1 2//1 4//1\nusemtl red\nf -3/1 -2/1 \\\n "
           "-1/1\nf 1 4 3\n";
}

std::string stlText() {
    std::ostringstream text;
    text << "solid tetrahedron\n";
    for (const Triangle& t : faces) {
        text << "facet normal 0 0 0\nouter loop\n";
        for (const std::uint32_t v : t)
            text << "vertex " << corners[v].transpose() << "\n";
        text << "endloop\nendfacet\n";
    }
    text << "endsolid tetrahedron\n";
    return text.str();
}

std::string stlBinary() {
    std::string bytes(80, 's');
    put(bytes, static_cast<std::uint32_t>(faces.size()));
    for (const Triangle& t : faces) {
        for (int i = 0; i < 3; ++i)
            put(bytes, 0.0F);
        for (const std::uint32_t v : t)
            for (const float coordinate : corners[v])
                put(bytes, coordinate);
        put(bytes, std::uint16_t{0});
    }
    return bytes;
}

std::string plyHeader(const std::string& format) {
    return "ply\nformat " + format + " 1.0\ncomment made by a test\nelement vertex 4\nproperty float x\n" +
           "property float y\nproperty float z\nproperty uchar red\nelement face 4\n" +
           "property list uchar int vertex_indices\nend_header\n";
}

std::string plyText() {
    std::ostringstream text;
    text << plyHeader("ascii");
    for (const Eigen::Vector3f& corner : corners)
        text << corner.transpose() << " 200\n";
    for (const Triangle& t : faces)
        text << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
    return text.str();
}

std::string plyBinary(bool bigEndian) {
    std::string bytes = plyHeader(bigEndian ? "binary_big_endian" : "binary_little_endian");
    for (const Eigen::Vector3f& corner : corners) {
        for (const float coordinate : corner)
            put(bytes, coordinate, bigEndian);
        put(bytes, std::uint8_t{200});
    }
    for (const Triangle& t : faces) {
        put(bytes, std::uint8_t{3});
        for (const std::uint32_t v : t)
            put(bytes, static_cast<std::int32_t>(v), bigEndian);
    }
    return bytes;
}

std::string offText() {
    std::ostringstream text;
    text << "OFF\n# tetrahedron\n4 4 6\n";
    for (const Eigen::Vector3f& corner : corners)
        text << corner.transpose() << "\n";
    for (const Triangle& t : faces)
        text << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
    return text.str();
}

std::string vtkText(const std::string& version = "3.0") {
    std::ostringstream text;
    text << "# vtk DataFile Version " << version
         << "\ntetrahedron\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n";
    for (const Eigen::Vector3f& corner : corners)
        text << corner.transpose() << "\n";
    text << "POLYGONS 4 16\n";
    for (const Triangle& t : faces)
        text << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
    return text.str();
}

class MeshDecoder : public testing::Test {
protected:
    std::filesystem::path write(const std::string& name, const std::string& content) {
        std::ofstream(m_folder / name, std::ios::binary) << content;
        return m_folder / name;
    }

    PolygonSoup read(const std::string& name, const std::string& content) {
        return decodeMesh(write(name, content));
    }

    std::string errorOf(const std::string& name, const std::string& content) {
        const std::filesystem::path file = write(name, content);
        try {
            decodeMesh(file);
        } catch (const FileError& error) {
            const std::string message = error.what();
            EXPECT_EQ(message.rfind(file.string() + ": ", 0), 0U) << message;
            EXPECT_EQ(message.find('\n'), message.npos) << message;
            return message.substr(file.string().size() + 2);
        }
        return "no error";
    }

    TemporaryFolder m_folder;
};

TEST_F(MeshDecoder, ReadsTheSameTetrahedronFromEveryFormat) {
    const std::vector<std::pair<std::string, std::string>> files{
        {"a.obj", objText()}, {"b.stl", stlText()},           {"c.stl", stlBinary()},
        {"d.ply", plyText()}, {"e.ply", plyBinary(false)},    {"f.PLY", plyBinary(true)},
        {"g.off", offText()}, {"h.glb", glb(gltfDocument())}, {"i.vtk", vtkText()}};
    for (const auto& [name, content] : files) {
        const RepairedMesh mesh = repair(read(name, content));
        EXPECT_EQ(mesh.mesh.vertices.size(), 4U) << name;
        EXPECT_EQ(mesh.mesh.triangles.size(), 4U) << name;
        EXPECT_TRUE(mesh.report.isClosed()) << name;
        EXPECT_EQ(mesh.report.flippedTriangles, 0U) << name;
        EXPECT_NEAR(enclosedVolume(mesh.mesh), 1.0 / 6, 1e-6) << name;
        // The first face is 0 2 1 in all of them, and vertices are numbered by first use.
        EXPECT_EQ(mesh.mesh.vertices[1], Eigen::Vector3d(0, 1, 0)) << name;
        EXPECT_EQ(mesh.mesh.vertices[2], Eigen::Vector3d(1, 0, 0)) << name;
    }
}

TEST_F(MeshDecoder, KeepsPolygonsTheirOrderAndUnusedVertices) {
    const PolygonSoup obj =
        read("quads.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
                          "o one\nusemtl a\nf 2 3 4 5\no two\nusemtl b\nf 3 6 7 4\n");
    EXPECT_EQ(obj.vertices.size(), 7U);
    EXPECT_EQ(obj.polygons, (std::vector<std::vector<std::uint32_t>>{{1, 2, 3, 4}, {2, 5, 6, 3}}));
    const PolygonSoup off =
        read("pentagon.off", "OFF 5 1 0\n0 0 0\n1 0 0\n2 1 0\n1 2 0\n0 1 0\n5 0 1 2 3 4\n");
    EXPECT_EQ(off.polygons, (std::vector<std::vector<std::uint32_t>>{{0, 1, 2, 3, 4}}));
}

TEST_F(MeshDecoder, KeepsTheTextureCoordinatesOfObjFaces) {
    using Corners = std::vector<Eigen::Vector2d>;
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    EXPECT_TRUE(read("none.obj", vertices + "f 1 2 3 4\n").textureCoordinates.empty());
    const PolygonSoup soup = read("some.obj", vertices + "vt 0.25 0.5\nvt 1\nvt 0 1 0\nvt 0.5 abc\nvt nan 0\n"
                                                         "f 1/1 2/2 3/-3\n" // height left out; from the end
                                                         "f 1/1 3/2 4/9\n"  // names none
                                                         "f 1/1 3/2 4\n"    // a corner without
                                                         "f 1/1 3/2 4/4\n"  // no number
                                                         "f 1/1 3/2 4/5\n"
                                                         "f 1/1/1 3/2/1 4/3/1\n");
    EXPECT_EQ(
        soup.textureCoordinates,
        (std::vector<Corners>{{{0.25, 0.5}, {1, 0}, {0, 1}}, {}, {}, {}, {}, {{0.25, 0.5}, {1, 0}, {0, 1}}}));
}

// A vertex at a seam has other coordinates in each face.
TEST_F(MeshDecoder, KeepsTheTextureCoordinatesOfPlyFaces) {
    const std::string header = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                               "property float s\nproperty float t\nelement face 2\n"
                               "property list uchar int vertex_indices\n"
                               "property list uchar float texcoord\nend_header\n";
    const std::array<std::array<float, 6>, 2> ofFaces{{{0, 0, 0.5F, 0, 0.5F, 1}, {0.75F, 0, 1, 1, 0.75F, 1}}};
    const std::array<std::array<int, 3>, 2> indices{{{0, 1, 2}, {0, 2, 3}}};
    std::string text = "ply\nformat ascii 1.0\n" + header;
    text += "0 0 0 9 9\n1 0 0 9 9\n1 1 0 9 9\n0 1 0 9 9\n";
    std::string binary = "ply\nformat binary_big_endian 1.0\n" + header;
    for (const int number : {0, 0, 0, 9, 9, 1, 0, 0, 9, 9, 1, 1, 0, 9, 9, 0, 1, 0, 9, 9})
        put(binary, static_cast<float>(number), true);
    for (std::size_t face = 0; face < 2; ++face) {
        text += "3";
        put(binary, std::uint8_t{3});
        for (const int vertex : indices[face]) {
            text += " " + std::to_string(vertex);
            put(binary, vertex, true);
        }
        text += " 6";
        put(binary, std::uint8_t{6});
        for (const float number : ofFaces[face]) {
            text += " " + std::to_string(number);
            put(binary, number, true);
        }
        text += "\n";
    }
    for (const PolygonSoup& soup : {read("text.ply", text), read("binary.ply", binary)}) {
        ASSERT_EQ(soup.textureCoordinates.size(), 2U);
        for (std::size_t face = 0; face < 2; ++face)
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_EQ(soup.textureCoordinates[face][i],
                          Eigen::Vector2d(ofFaces[face][2 * i], ofFaces[face][2 * i + 1]));
    }
}

TEST_F(MeshDecoder, AppliesNodeTransformsAndRepeatsInstances) {
    nlohmann::json document = gltfDocument();
    document["nodes"] = nlohmann::json::parse(
        R"([{"children": [1, 2], "scale": [2, 2, 2]}, {"mesh": 0, "translation": [10, 0, 0]},
            {"mesh": 0, "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476]}])");
    const PolygonSoup soup = read("nodes.glb", glb(document));
    ASSERT_EQ(soup.vertices.size(), 8U);
    EXPECT_LT((soup.vertices[1] - Eigen::Vector3d(22, 0, 0)).norm(), 1e-5);
    EXPECT_LT((soup.vertices[5] - Eigen::Vector3d(0, 2, 0)).norm(), 1e-5);
    EXPECT_EQ(soup.polygons.size(), 8U);
}

TEST_F(MeshDecoder, ReadsGltfWithABufferBesideIt) {
    nlohmann::json document = gltfDocument();
    document["buffers"][0]["uri"] = "mesh.bin";
    EXPECT_THAT(errorOf("mesh.gltf", document.dump()), HasSubstr("mesh.bin"));
    write("mesh.bin", meshBuffer());
    EXPECT_EQ(read("mesh.gltf", document.dump()).polygons.size(), 4U);
    write("mesh.bin", meshBuffer().substr(0, 50));
    EXPECT_THAT(errorOf("mesh.gltf", document.dump()), AllOf(HasSubstr("cut off"), HasSubstr("72")));
}

TEST_F(MeshDecoder, RefusesMissingEmptyAndUnknownFiles) {
    EXPECT_THROW(decodeMesh(m_folder / "none.obj"), FileError);
    EXPECT_THROW(decodeMesh(m_folder.path()), FileError);
    for (const std::string& ending : meshFileEndings())
        EXPECT_THAT(errorOf("empty." + ending, ""), HasSubstr("empty"));
    EXPECT_THAT(errorOf("mesh.xyz", "1 2 3"), AllOf(HasSubstr("unknown kind"), HasSubstr(".stl")));
}

TEST_F(MeshDecoder, RefusesContentOfAnotherKindThanTheEndingSays) {
    EXPECT_THAT(errorOf("a.stl", plyText()), AllOf(HasSubstr("PLY"), HasSubstr(".ply")));
    EXPECT_THAT(errorOf("b.ply", glb(gltfDocument())), HasSubstr("GLB"));
    EXPECT_THAT(errorOf("c.obj", "\x89PNG\r\n\x1a\n"), HasSubstr("PNG"));
    EXPECT_THAT(errorOf("d.stl", "Dear reader,\nthis is a letter and no mesh.\n"), HasSubstr("no STL"));
    for (const std::string& ending : meshFileEndings())
        EXPECT_NE(errorOf("letter." + ending, "Dear reader,\nthis is a letter and no mesh.\n"), "no error")
            << ending;
    std::string noise;
    for (std::uint32_t i = 0, x = 1; i < 3000; ++i)
        noise += static_cast<char>((x = x * 1664525 + 1013904223) >> 24);
    for (const std::string& ending : meshFileEndings())
        EXPECT_NE(errorOf("noise." + ending, noise), "no error") << ending;
}

TEST_F(MeshDecoder, RefusesFilesCutOffAnywhere) {
    const std::vector<std::pair<std::string, std::string>> files{
        {"b.stl", stlText()},           {"c.stl", stlBinary()},     {"d.ply", plyText()},
        {"e.ply", plyBinary(false)},    {"f.ply", plyBinary(true)}, {"g.off", offText()},
        {"h.glb", glb(gltfDocument())}, {"i.vtk", vtkText()}};
    for (const auto& [name, content] : files)
        for (std::size_t size = 1; size < content.size() - (name == "b.stl" ? 13 : 2);
             ++size) // the solid's name
            EXPECT_NE(errorOf(name, content.substr(0, size)), "no error") << name << " cut off at " << size;
    // In OBJ nothing says how many faces there are: a cut between two of them cannot be seen, one within them
    // can.
    EXPECT_THAT(errorOf("a.obj", objText().substr(0, objText().size() - 3)),
                AllOf(HasSubstr("line"), HasSubstr("three corners")));
    EXPECT_THAT(errorOf("a.obj", "v 0 0 0\nv 1 0"), HasSubstr("line 2"));
}

TEST_F(MeshDecoder, RefusesSurfacesWithoutATriangle) {
    EXPECT_THAT(errorOf("points.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"), HasSubstr("no triangle"));
    EXPECT_THAT(errorOf("points.off", "OFF\n1 0 0\n0 0 0\n"), HasSubstr("triangle"));
    EXPECT_NE(errorOf("empty.stl", "solid nothing\nendsolid nothing\n"), "no error");
    std::string emptyStl(84, '\0');
    EXPECT_NE(errorOf("emptybinary.stl", emptyStl), "no error");
    EXPECT_THAT(errorOf("points.vtk",
                        "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 0 0\n"
                        "VERTICES 1 2\n1 0\n"),
                HasSubstr("no triangle"));
}

TEST_F(MeshDecoder, RefusesCoordinatesThatAreNotFinite) {
    for (const std::string value : {"nan", "inf", "1e400"}) {
        EXPECT_THAT(errorOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 " + value + " 0\nf 1 2 3\n"),
                    HasSubstr("vertex 2"));
        EXPECT_NE(errorOf("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 " + value + " 0\n3 0 1 2\n"), "no error")
            << value;
        EXPECT_THAT(
            errorOf("a.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n"
                             "0 0 0 1 0 0 0 " +
                                 value + " 0\nPOLYGONS 1 4\n3 0 1 2\n"),
            HasSubstr("vertex 2"));
    }
    std::string stl = stlBinary();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(stl.data() + 84 + 12, &nan, sizeof nan);
    EXPECT_THAT(errorOf("a.stl", stl), HasSubstr("finite"));
    std::string buffer = meshBuffer();
    std::memcpy(buffer.data(), &nan, sizeof nan);
    EXPECT_THAT(errorOf("a.glb", glb(gltfDocument(), buffer)), HasSubstr("finite"));
    std::string ply = plyBinary(false);
    std::memcpy(ply.data() + plyHeader("binary_little_endian").size(), &nan, sizeof nan);
    EXPECT_THAT(errorOf("a.ply", ply), HasSubstr("finite"));
}

TEST_F(MeshDecoder, RefusesIndicesOutOfRange) {
    EXPECT_THAT(errorOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\n"),
                AllOf(HasSubstr("line 5"), HasSubstr("vertex 4")));
    EXPECT_THAT(errorOf("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n"), HasSubstr("line 4"));
    EXPECT_THAT(errorOf("c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n"), HasSubstr("line 4"));
    EXPECT_NE(errorOf("d.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "no error");
    std::string ply = plyBinary(false);
    const std::int32_t index = 77;
    std::memcpy(ply.data() + ply.size() - 4, &index, sizeof index);
    EXPECT_NE(errorOf("e.ply", ply), "no error");
    std::string buffer = meshBuffer();
    buffer[buffer.size() - 1] = 7;
    EXPECT_NE(errorOf("f.glb", glb(gltfDocument(), buffer)), "no error");
    EXPECT_THAT(
        errorOf("g.vtk",
                "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0\n1 0 0\n"
                "0 1 0\nPOLYGONS 1 4\n3 0 1 3\n"),
        AllOf(HasSubstr("point 3"), HasSubstr("line 10")));
}

TEST_F(MeshDecoder, DoesNotBelieveHeadersThatLie) {
    std::string stl = stlBinary();
    const std::uint32_t many = 4000000000U;
    std::memcpy(stl.data() + 80, &many, sizeof many);
    EXPECT_THAT(errorOf("a.stl", stl), HasSubstr("4000000000"));
    std::string ply = plyBinary(false);
    ply.replace(ply.find("vertex 4"), 8, "vertex 4000000000");
    EXPECT_THAT(errorOf("b.ply", ply), HasSubstr("4000000000"));
    std::string ascii = plyText();
    ascii.replace(ascii.find("face 4"), 6, "face 99999999999999");
    EXPECT_NE(errorOf("c.ply", ascii), "no error");
    EXPECT_NE(errorOf("d.off", "OFF\n4000000000 4000000000 0\n0 0 0\n"), "no error");
    EXPECT_NE(errorOf("e.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"), "no error");
    for (const auto& change : std::vector<std::function<void(nlohmann::json&)>>{
             [](auto& json) { json["accessors"][0]["count"] = 4000000000U; },
             [](auto& json) { json["accessors"][1]["count"] = 13; },
             [](auto& json) {
                 json["accessors"][0].erase("bufferView"), json["accessors"][0]["count"] = 4000000000U;
             },
             [](auto& json) { json["bufferViews"][0]["byteLength"] = 4000000000U; },
             [](auto& json) { json["bufferViews"][0]["byteOffset"] = -4; },
             [](auto& json) { json["bufferViews"][1]["buffer"] = 3; },
             [](auto& json) { json["buffers"][0]["byteLength"] = 4000000000U; },
             [](auto& json) { json["accessors"][0]["bufferView"] = "zero"; },
             [](auto& json) { json["accessors"] = 5; },
             [](auto& json) { json["meshes"][0]["primitives"] = 5; },
             [](auto& json) { json["meshes"][0]["primitives"][0] = 5; },
             [](auto& json) { json["meshes"][0]["primitives"][0]["attributes"] = "none"; },
             [](auto& json) { json["meshes"][0] = "none"; }, [](auto& json) { json["nodes"] = 5; },
             [](auto& json) { json["nodes"][0]["mesh"] = 5; },
             [](auto& json) { json["scenes"][0]["nodes"] = {5}; }, [](auto& json) { json["scene"] = 5; },
             [](auto& json) { json["nodes"][0]["children"] = {0}; },
             [](auto& json) { json["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }}) {
        nlohmann::json document = gltfDocument();
        change(document);
        EXPECT_NE(errorOf("f.glb", glb(document)), "no error") << document;
    }
    EXPECT_THAT(
        errorOf("g.vtk",
                "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 4000000000 float\n0 0 0\n"),
        HasSubstr("4000000000"));
}

} // namespace
} // namespace esm
