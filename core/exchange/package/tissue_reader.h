#pragma once

#include "core/exchange/package/glb.h"
#include "core/exchange/package/packaged_tissue.h"

namespace esm {

/// The part of a package's JSON that its model is in. @throws InvalidModel: another kind of glTF, or of a
/// newer version
JsonReader springMassOf(const JsonReader& gltf);

/// Problems in how the glTF says what it is.
void checkNamesOfExtension(const JsonReader& gltf);

/// Reads the tissue of a package that cannot be trusted. Where there are problems, it is of use for nothing.
/// @param extension as springMassOf() gives it
PackagedTissue readTissue(const JsonReader& extension, const GltfArrayReader& arrays);

} // namespace esm
