#include "core/exchange/meshes/mesh_file.h"

#include "core/decoding/decoder_process.h"
#include "core/exchange/meshes/mesh_stream.h"
#include "core/support/errors.h"

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

void convertToMetres(std::vector<Eigen::Vector3d>& points, LengthUnit unit, UpAxis up) {
    const double factor = metresPer(unit);
    for (Eigen::Vector3d& v : points) {
        if (up == UpAxis::Z) v = Eigen::Vector3d(v.x(), v.z(), -v.y());
        v *= factor;
    }
}

void convertToMetres(PolygonSoup& soup, LengthUnit unit, UpAxis up) {
    convertToMetres(soup.vertices, unit, up);
}

} // namespace esm
