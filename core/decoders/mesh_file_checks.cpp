#include "core/decoders/mesh_file_checks.h"

#include "core/support/errors.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <string_view>

namespace esm {

namespace fs = std::filesystem;

namespace {

struct Signature {
    std::string_view start;
    std::string_view ending; ///< of a mesh file that may start so; empty for other kinds
    std::string_view name;
};

constexpr Signature signatures[] = {
    {"glTF", "glb", "a GLB file"},
    {"ply\n", "ply", "a PLY file"},
    {"ply\r", "ply", "a PLY file"},
    {"OFF", "off", "an OFF file"},
    {"# vtk ", "vtk", "a VTK file"},
    {"<?xml", "", "an XML file"},
    {"\x89PNG", "", "a PNG picture"},
    {"\xff\xd8\xff", "", "a JPEG picture"},
    {"PK\x03\x04", "", "a zip archive"},
    {"\x1f\x8b", "", "a gzip archive"},
    {"%PDF", "", "a PDF document"},
    {"Kaydara FBX", "", "an FBX file"},
    {"\x7f"
     "ELF",
     "", "a program"},
    {"BLENDER", "", "a Blender file"},
};

std::optional<Signature> signatureOf(std::string_view content) {
    for (const Signature& signature : signatures)
        if (content.substr(0, signature.start.size()) == signature.start) return signature;
    return std::nullopt;
}

} // namespace

/// By the first bytes before anything else: a picture that was renamed gets a word that helps, and no reader
/// sees what is not its own.
std::optional<std::size_t> checkMeshContent(const fs::path& file, const Bytes& content,
                                            const std::string& ending) {
    if (content.empty()) throw FileError(file, "is empty; export the mesh again");
    const std::string_view text(reinterpret_cast<const char*>(content.data()), content.size());
    const std::optional<Signature> signature = signatureOf(text);
    if (signature && signature->ending != ending) {
        const std::string advice = signature->ending.empty()
                                       ? "choose a mesh file"
                                       : "rename it so that it ends in ." + std::string(signature->ending);
        throw FileError(file,
                        "is " + std::string(signature->name) + " and not what its ending says; " + advice);
    }
    if (ending == "off") return checkOff(file, content);
    if (ending == "stl") return checkStl(file, content);
    if (ending == "ply") return checkPly(file, content);
    if (ending == "gltf") return checkGltf(file, content);
    if (ending == "glb") return checkGlb(file, content);
    return std::nullopt;
}

} // namespace esm
