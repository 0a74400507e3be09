#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace esm {

/// What of a package's glTF is not as `docs/model-package.md` says, though the model can be read: a transform
/// by which viewers show the mesh elsewhere than it is simulated, data outside the file. Empty when all is
/// well.
std::vector<std::string> containerWarnings(const nlohmann::ordered_json& gltf);

} // namespace esm
