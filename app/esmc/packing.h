#pragma once

#include "core/project/project.h"

namespace esm {

/// Lays the surface out in the texture, as the project's settings say. @throws InvalidModel
void pack(Project& project);

/// A project that nobody packed gets its atlas where one is needed first.
void packIfNeeded(Project& project);

} // namespace esm
