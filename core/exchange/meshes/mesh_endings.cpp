#include "core/exchange/meshes/mesh_file.h"

namespace esm {

const std::vector<std::string>& meshFileEndings() {
    static const std::vector<std::string> endings{"obj", "stl", "ply", "off", "gltf", "glb", "vtk"};
    return endings;
}

std::string meshFileEnding(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    if (!ending.empty()) ending.erase(0, 1);
    for (char& letter : ending)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    return ending;
}

} // namespace esm
