#pragma once

#include "core/project/project.h"
#include "core/support/progress.h"

#include <filesystem>

namespace esm {

/// The project file `.esm`: a zip with a versioned JSON manifest, binary arrays and the photos' own files.
/// Specified in `docs/project-file.md`.
/// This is the newest version; a file is of the oldest that has all it holds, see `versionOf()`.
constexpr int projectFileVersion = 13;

struct OpenedProject {
    Project project;
    std::vector<std::string> warnings; ///< what is wrong with the file, though it can be worked with
};

/// Every number comes back as it was saved, bit by bit.
/// @throws FileError: missing, not a project, damaged (which entry), or of a newer version; Cancelled
OpenedProject openProject(const std::filesystem::path& file, const Progress& progress = {});

/// The same for who has nobody to warn.
Project loadProject(const std::filesystem::path& file, const Progress& progress = {});

/// Saves atomically. The same project gives the same bytes.
/// @throws FileError, also for a project with problems, which could not be loaded again; an existing file is
/// then as it was, as it is where progress says Cancelled
void saveProject(const Project& project, const std::filesystem::path& file, const Progress& progress = {});

/// All problems at once, and all that opening warns of; empty when the file is whole. @throws FileError
/// when there is no file to read
std::vector<std::string> validateProjectFile(const std::filesystem::path& file);

} // namespace esm
