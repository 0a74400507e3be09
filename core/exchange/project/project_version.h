#pragma once

#include "core/project/project.h"

namespace esm {

/// The oldest version of the project file that has all that a project holds, see `docs/project-file.md`.
int projectVersionOf(const Project& project);

} // namespace esm
