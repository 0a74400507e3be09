#pragma once

#include "core/project/project.h"

namespace esm {

enum class LayersMeant { All, Photographs };

/// The layer that --layer names. @throws UsageError where none of those that are meant has the name, saying
/// which there are, or more than one
TextureLayer& layerNamed(Project& project, const std::string& name, LayersMeant meant);

} // namespace esm
