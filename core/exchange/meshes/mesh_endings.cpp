#include "core/exchange/meshes/mesh_file.h"

#include "core/support/letters.h"

namespace esm {

const std::vector<std::string>& meshFileEndings() {
    static const std::vector<std::string> endings{"obj", "stl", "ply", "off", "gltf", "glb", "vtk"};
    return endings;
}

std::string meshFileEnding(const std::filesystem::path& file) {
    const std::string ending = endingOf(file);
    return ending.empty() ? ending : ending.substr(1);
}

} // namespace esm
