#pragma once

#include "core/exchange/package/glb.h"

#include <string>
#include <vector>

namespace esm {

/// What of a package's glTF is not as `docs/model-package.md` says, though the model can be read: a transform
/// by which viewers show the mesh elsewhere than it is simulated, data outside the file, a buffer of another
/// length than its data, extensions without which others refuse the file. Empty when all is well.
std::vector<std::string> containerWarnings(const Glb& glb);

} // namespace esm
