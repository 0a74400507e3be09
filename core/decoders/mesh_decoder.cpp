#include "core/decoders/mesh_decoder.h"

#include "core/decoders/gltf_address.h"
#include "core/decoders/mesh_file_checks.h"
#include "core/decoders/obj_mesh.h"
#include "core/decoders/vtk_polydata.h"
#include "core/exchange/meshes/mesh_file.h"
#include "core/support/errors.h"
#include "core/support/joined.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include <algorithm>
#include <limits>
#include <new>

namespace esm {

namespace fs = std::filesystem;

namespace {

constexpr const char* withoutTriangle =
    "has no triangle: it holds lines or points alone, or is cut off; export the surface, and the whole of it";

/// Row-major 3×4 part of a node's transform, in double so that parts that meet keep meeting.
using Transform = Eigen::Matrix<double, 3, 4>;

Transform compose(const Transform& outer, const aiMatrix4x4& m) {
    Eigen::Matrix4d inner;
    inner << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4;
    return outer * inner;
}

void appendMesh(const fs::path& file, const aiMesh& mesh, const Transform& transform, PolygonSoup& soup) {
    if (mesh.mNumVertices > std::numeric_limits<std::uint32_t>::max() - soup.vertices.size())
        throw FileError(file, "has more vertices than can be numbered; export a coarser mesh");
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    const auto placeOf = [&](std::uint32_t vertex) {
        const aiVector3D& place =
            mesh.mTextureCoords[0][vertex]; // v up, also of glTF, where files have it down
        return Eigen::Vector2d(place.x, place.y);
    };
    for (unsigned int i = 0; i < mesh.mNumVertices; ++i) {
        const aiVector3D& v = mesh.mVertices[i];
        soup.vertices.emplace_back(transform * Eigen::Vector4d(v.x, v.y, v.z, 1));
    }
    for (unsigned int i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices < 3) continue;
        std::vector<std::uint32_t> polygon(face.mIndices, face.mIndices + face.mNumIndices);
        std::vector<Eigen::Vector2d> places;
        for (std::uint32_t& corner : polygon) {
            if (corner >= mesh.mNumVertices)
                throw FileError(file, "has a face that names vertex " + std::to_string(corner) +
                                          ", but there are " + std::to_string(mesh.mNumVertices) +
                                          "; export it again");
            if (mesh.HasTextureCoords(0)) places.push_back(placeOf(corner));
            corner += first;
        }
        soup.textureCoordinates.push_back(std::move(places));
        soup.polygons.push_back(std::move(polygon));
    }
}

void appendNode(const fs::path& file, const aiScene& scene, const aiNode& node, const Transform& parent,
                PolygonSoup& soup) {
    const Transform transform = compose(parent, node.mTransformation);
    for (unsigned int i = 0; i < node.mNumMeshes; ++i)
        appendMesh(file, *scene.mMeshes[node.mMeshes[i]], transform, soup);
    for (unsigned int i = 0; i < node.mNumChildren; ++i)
        appendNode(file, scene, *node.mChildren[i], transform, soup);
}

/// Faces of all meshes that are surfaces, each once however often it is placed.
std::size_t faceCountOf(const aiScene& scene) {
    std::size_t count = 0;
    for (unsigned int i = 0; i < scene.mNumMeshes; ++i)
        if (scene.mMeshes[i]->mPrimitiveTypes & (aiPrimitiveType_TRIANGLE | aiPrimitiveType_POLYGON))
            count += scene.mMeshes[i]->mNumFaces;
    return count;
}

/// Opens nothing but the file itself and what a glTF document may name.
class NearbyFiles : public Assimp::DefaultIOSystem {
public:
    explicit NearbyFiles(const fs::path& file) : m_file(file.string()) {}

    Assimp::IOStream* Open(const char* name, const char* mode) override {
        if (name == m_file) return DefaultIOSystem::Open(name, mode);
        // The importer puts the file's folder before an address.
        const std::string folder = m_file.substr(0, m_file.rfind('/') + 1), wanted = name;
        if (wanted.compare(0, folder.size(), folder) != 0) return nullptr;
        return DefaultIOSystem::Open(fileAtAddress(m_file, wanted.substr(folder.size())).c_str(), mode);
    }

private:
    std::string m_file;
};

/// No flags: assimp is to change nothing, neither weld nor drop nor turn, as all that is done to a mesh is
/// told to the user later. Faces that it left out in silence are found by counting.
PolygonSoup readWithAssimp(const fs::path& file, const std::optional<std::size_t>& faceCount) {
    Assimp::Importer importer;
    importer.SetIOHandler(new NearbyFiles(file)); // which the importer deletes
    const aiScene* scene = importer.ReadFile(file.string(), 0);
    if (!scene || !scene->mRootNode) {
        std::string reason = importer.GetErrorString();
        if (reason.find("bad_alloc") != reason.npos) throw std::bad_alloc();
        std::replace(reason.begin(), reason.end(), '\n', ' ');
        throw FileError(file,
                        "cannot be read as a mesh (" + reason + "); export it again or in another format");
    }
    if (const std::size_t delivered = faceCountOf(*scene); faceCount && delivered != *faceCount)
        throw FileError(file, "announces " + std::to_string(*faceCount) + " faces, of which " +
                                  std::to_string(delivered) +
                                  " can be read; the others name missing vertices; export it again");
    PolygonSoup soup;
    appendNode(file, *scene, *scene->mRootNode, Transform::Identity(), soup);
    return soup;
}

void checkSurface(const fs::path& file, const PolygonSoup& soup) {
    if (soup.polygons.empty()) throw FileError(file, withoutTriangle);
    for (std::size_t i = 0; i < soup.vertices.size(); ++i)
        if (!soup.vertices[i].allFinite())
            throw FileError(file, "has a coordinate that is not a finite number at vertex " +
                                      std::to_string(i) +
                                      " (counted from 0); mend it in the program that made it");
}

/// In the place of what the importer made of them. Where some face was left out they cannot be told apart,
/// and none are kept.
void takeFaceCoordinates(FaceCoordinates coordinates, PolygonSoup& soup) {
    if (coordinates.empty()) return;
    soup.textureCoordinates.clear();
    if (coordinates.size() != soup.polygons.size()) return;
    for (std::size_t i = 0; i < coordinates.size(); ++i)
        if (coordinates[i].size() != soup.polygons[i].size()) coordinates[i].clear();
    soup.textureCoordinates = std::move(coordinates);
}

/// Places that are no numbers are none, and a file that has none at all has no list of them.
void dropUselessPlaces(PolygonSoup& soup) {
    bool hasPlaces = false;
    for (std::vector<Eigen::Vector2d>& places : soup.textureCoordinates) {
        if (std::any_of(places.begin(), places.end(), [](const auto& place) { return !place.allFinite(); }))
            places.clear();
        hasPlaces = hasPlaces || !places.empty();
    }
    if (!hasPlaces) soup.textureCoordinates.clear();
}

} // namespace

PolygonSoup decodeMesh(const fs::path& file) {
    const Bytes content = readFile(file);
    const std::string ending = meshFileEnding(file);
    const std::vector<std::string>& known = meshFileEndings();
    if (std::find(known.begin(), known.end(), ending) == known.end())
        throw FileError(file,
                        "is of an unknown kind; mesh files end in ." + joined(meshFileEndings(), ", ."));
    const std::optional<std::size_t> faceCount = checkMeshContent(file, content, ending);
    if (faceCount && *faceCount == 0) throw FileError(file, withoutTriangle);
    PolygonSoup soup = ending == "vtk"   ? parseVtkPolydata(file, content)
                       : ending == "obj" ? parseObj(file, content)
                                         : readWithAssimp(file, faceCount);
    checkSurface(file, soup);
    if (ending == "ply") takeFaceCoordinates(plyFaceCoordinates(file, content), soup);
    dropUselessPlaces(soup);
    return soup;
}

} // namespace esm
