#pragma once

#include "core/model/scene.h"

namespace esm {

/// The scene without what happens at set times: forces, led nodes, instruments, splits and pressures that
/// change. What holds the organ or acts on it all the time stays.
Scene withoutEvents(Scene scene);

/// Whether anything happens in a scene at set times.
bool hasEvents(const Scene& scene);

} // namespace esm
