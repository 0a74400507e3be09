#pragma once

#include "core/project/project.h"

namespace esm {

/// Lays the surface out in the texture, as the project's settings say. @throws InvalidModel, Cancelled
void pack(Project& project, const Progress& progress = {});

/// What pack() makes of a mesh; where the size cannot hold it, doubles the size up to 8192.
/// @throws InvalidModel when even that is too small; Cancelled
Atlas packFitting(const TriangleMesh& mesh, AtlasOptions options, const Progress& progress = {});

/// A project that nobody packed gets its atlas where one is needed first, on pages as large as that takes.
/// @throws InvalidModel, Cancelled as packFitting()
void packIfNeeded(Project& project, const Progress& progress = {});

/// Takes an atlas, and the settings it was packed with, where the project has none.
void takeAtlas(Project& project, std::shared_ptr<const Atlas> atlas);

} // namespace esm
