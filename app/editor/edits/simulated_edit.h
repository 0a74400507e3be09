#pragma once

#include "core/project/project.h"

namespace esm {

/// Takes over what withDetail() and withMeasuredRun() have made of a project, and nothing else of it: other
/// edits may have come while they worked, as of a photo that was prepared.
inline void takeSimulated(Project& project, const Project& made) {
    project.network = made.network;
    project.base = made.base;
    project.scene = made.scene;
    project.stepping = made.stepping;
    project.accuracy = made.accuracy;
}

} // namespace esm
