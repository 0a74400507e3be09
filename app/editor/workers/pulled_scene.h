#pragma once

#include "app/editor/workers/poke.h"
#include "core/project/project.h"

#include <QString>

#include <optional>

namespace esm {

/// What moves an organ that is tried in another program.
struct TriedMotion {
    Scene scene;
    QString name; ///< as in "the organ is moved by …" and "try … in SOFA"
};

/// Whether a recorded poke has a pull that lasts: what sceneOfPull() takes.
bool hasPull(const Poke& poke);

/// A recorded poke as a scene, which other programs can run: the hand's first pull that lasts, from when it
/// took hold until it let go, as nodes that are led, in place of what happens in the project's scene at set
/// times. None where the poke has no such pull, or all that it took hold of is fixed.
/// @param tissue the project's
std::optional<Scene> sceneOfPull(const Poke& poke, const Project& project, const TissueModel& tissue);

} // namespace esm
