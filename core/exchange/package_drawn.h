#pragma once

#include "core/exchange/glb.h"
#include "core/exchange/json_reader.h"
#include "core/exchange/model_package.h"

namespace esm {

/// Reads how a package shows its surface: where its triangles stand in the texture, the texture's pages, and
/// its preview picture. What is drawn must be the surface that is simulated, which the package holds already;
/// what is not so is added to the problems.
void readDrawn(const JsonReader& extension, const GltfArrayReader& arrays, std::vector<std::string>& problems,
               ModelPackage& package);

} // namespace esm
