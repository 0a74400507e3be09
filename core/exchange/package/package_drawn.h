#pragma once

#include "core/exchange/model_package.h"
#include "core/exchange/package/glb.h"
#include "core/support/json_reader.h"

namespace esm {

/// Reads how a package shows its surface: where its triangles stand in the texture, the texture's pages, and
/// its preview picture. What is drawn must be the surface that is simulated, which the package holds already;
/// what is not so is added to the problems.
void readDrawn(const JsonReader& extension, const GltfArrayReader& arrays, std::vector<std::string>& problems,
               ModelPackage& package);

} // namespace esm
