#pragma once

#include "core/exchange/provenance.h"
#include "core/geometry/triangle_mesh.h"
#include "core/model/equivalent_material.h"
#include "core/model/stepping.h"
#include "core/model/tissue_model.h"

#include <filesystem>

namespace esm {

/// The model package for simulators: one `.glb`, a textured mesh to any viewer, with the spring-mass model in
/// the extension `ESM_spring_mass`. Specified in `docs/model-package.md`. This is the newest version; a
/// package is of the oldest that has all it holds, see `versionOf()`.
inline constexpr int modelPackageVersion = 9;

/// What of a package moves, and the surface that it carries: all that a simulator needs which draws by
/// its own means. Nodes, springs and triangles are numbered as in the project it was made from.
struct PackagedTissue {
    std::string name;
    TriangleMesh mesh; ///< drawn triangles over the welded vertices
    TissueModel tissue;
    std::optional<MeasuredStepping> stepping;     ///< that is recommended
    std::vector<PartPressure> pressures{};        ///< that press on cavities of the tissue from within
    std::optional<EquivalentMaterial> material{}; ///< that the springs stand for, where it is known
    std::optional<Provenance> provenance{};       ///< none in files of before there was any
};

/// Reads it without decoding any picture. @throws FileError: damaged, not a model package, of a newer version
PackagedTissue loadPackagedTissue(const std::filesystem::path& file);

/// Problems of what a package says of its tissue beyond what moves it.
std::vector<std::string> descriptionProblems(const PackagedTissue& package);

/// Every problem of the tissue, of the surface, and of how one carries the other.
std::vector<std::string> validate(const PackagedTissue& package);

} // namespace esm
