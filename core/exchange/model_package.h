#pragma once

#include "core/model/project.h"
#include "core/support/progress.h"

#include <filesystem>

namespace esm {

/// The model package for simulators: one `.glb`, a textured mesh to any viewer, with the spring-mass model in the
/// extension `ESM_spring_mass`. Specified in `docs/model-package.md`.
constexpr int modelPackageVersion = 1;

/// What a package holds.
struct ModelPackage {
    TriangleMesh mesh; ///< drawn triangles over the welded vertices
    TissueModel tissue;
    std::vector<Region> regions;
    std::vector<Image> textures;
};

/// Bakes the textures and writes the package atomically. @throws FileError, Cancelled
void exportPackage(const Project& project, const std::filesystem::path& file, const Progress& progress = {});

/// @throws FileError: damaged, or not a model package
ModelPackage loadPackage(const std::filesystem::path& file);

/// All problems at once; empty when the package is whole.
std::vector<std::string> validatePackage(const std::filesystem::path& file);

} // namespace esm
