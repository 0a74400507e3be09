#pragma once

#include "core/dynamics/block_entries.h"
#include "core/dynamics/spring_system.h"

namespace esm {

/// Adds −p·∂²V/∂x², how a pressure, Pa, turns with the wall of a cavity: sparse, and maybe negative.
/// @param places of the wall, m
void addTurning(const SpringSystem::Filled& cavity, double pressure, const Vectors& places,
                BlockEntries& entries);

} // namespace esm
