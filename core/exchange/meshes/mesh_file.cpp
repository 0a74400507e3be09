#include "core/exchange/meshes/mesh_file.h"

#include "core/decoding/decoder_process.h"
#include "core/exchange/meshes/mesh_stream.h"
#include "core/support/errors.h"
#include "core/support/sha256.h"
#include "core/support/text_line.h"

namespace esm {

namespace fs = std::filesystem;

namespace {

DecodingLimits limitsFor(const fs::path& file) {
    if (meshFileEnding(file) == "gltf") return largestMeshDecodingLimits();
    const std::uint64_t bytes = regularFileSize(file);
    if (bytes > mostMeshFileBytes())
        throw FileError(file, "is " + inGigabytes(bytes) +
                                  " large, which with what is made of it would fill this " +
                                  "machine's memory: at most " + inGigabytes(mostMeshFileBytes()) +
                                  " can be read; reduce the mesh in the program it comes from");
    return meshDecodingLimits(bytes);
}

} // namespace

PolygonSoup readMeshFile(const fs::path& file, const Progress& progress) {
    const DecodingTask task{file, {"mesh", file.string()}, nullptr, limitsFor(file)};
    DecodedStream stream = decodeApart(task, progress);
    return readSoup(stream);
}

MeshSource meshSourceOf(const fs::path& file, const Progress& progress) {
    ProgressParts parts(progress);
    const Bytes content = readFile(file, largestFile, parts.next(0.2));
    return {asLine(file.filename().string()), sha256Of(content, parts.rest())};
}

Eigen::Matrix3d turnedUp(UpAxis up) {
    Eigen::Matrix3d turned;
    switch (up) {
    case UpAxis::Y:
        return Eigen::Matrix3d::Identity();
    case UpAxis::Z:
        turned << 1, 0, 0, 0, 0, 1, 0, -1, 0;
        break;
    case UpAxis::X:
        turned << 0, -1, 0, 1, 0, 0, 0, 0, 1;
        break;
    case UpAxis::MinusY:
        turned << 1, 0, 0, 0, -1, 0, 0, 0, -1;
        break;
    case UpAxis::MinusZ:
        turned << 1, 0, 0, 0, 0, -1, 0, 1, 0;
        break;
    case UpAxis::MinusX:
        turned << 0, 1, 0, -1, 0, 0, 0, 0, 1;
        break;
    }
    return turned;
}

void convertToMetres(std::vector<Eigen::Vector3d>& points, LengthUnit unit, UpAxis up) {
    const double factor = metresPer(unit);
    const Eigen::Matrix3d turned = turnedUp(up);
    for (Eigen::Vector3d& v : points)
        v = turned * v * factor;
}

void convertToMetres(PolygonSoup& soup, LengthUnit unit, UpAxis up) {
    convertToMetres(soup.vertices, unit, up);
}

} // namespace esm
