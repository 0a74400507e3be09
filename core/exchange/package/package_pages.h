#pragma once

#include "core/exchange/simulators/handover.h"

namespace esm {

/// @throws Cancelled
PackagePages packagePages(const Project& project, const Progress& progress);

} // namespace esm
