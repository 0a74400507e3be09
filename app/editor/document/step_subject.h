#pragma once

#include "core/project/project.h"

#include <QString>

namespace esm {

/// The name of the region or layer that an edit is about: the only one that it changes, adds or removes.
/// Empty where it is about none, or about several.
QString stepSubject(const Project& before, const Project& after);

} // namespace esm
