#pragma once

#include "core/dynamics/spring_system.h"

#include <string>

namespace esm {

/// Which cavity has burst at these places, m, and what to do; empty where none has. One that has grown beyond
/// ten times its volume at rest holds no pressure any more.
std::string burstOf(const SpringSystem& system, const Vectors& positions);

} // namespace esm
