#pragma once

#include "app/editor/workers/poke.h"
#include "core/project/project.h"

#include <QString>

#include <optional>

namespace esm {

/// What moves an organ that is tried in another program.
struct TriedMotion {
    Scene scene;
    QString name; ///< as in "the organ is moved by …"
};

/// A recorded poke as a scene, which other programs can run: the hand's first pull, from when it took hold
/// until it let go, as nodes that are led. Of the project's scene gravity and what holds the organ stay.
/// None where the poke has no pull, or none that lasts.
/// @param tissue the project's
std::optional<Scene> sceneOfPull(const Poke& poke, const Project& project, const TissueModel& tissue);

} // namespace esm
