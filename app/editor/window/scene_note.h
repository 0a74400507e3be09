#pragma once

#include "core/model/scene.h"

#include <QString>

namespace esm {

/// What the status line says of a project's scene, and what it explains when asked, with actions' ids for
/// their keys (`withKeys()`); empty where the scene holds nothing that happens at set times.
struct SceneNote {
    QString title, explanation;
};
SceneNote sceneNote(const Scene& scene);

} // namespace esm
