#pragma once

#include "core/model/scene.h"

namespace esm {

/// Whether anything happens in a scene at set times: forces, led nodes, instruments, splits, or pressures
/// that change.
bool hasEvents(const Scene& scene);

/// The scene without what happens at set times, and then without how long that lasts and what is recorded of
/// it. What holds the organ or acts on it all the time stays.
Scene withoutEvents(Scene scene);

} // namespace esm
