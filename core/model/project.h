#pragma once

#include "core/geometry/repair.h"
#include "core/model/detail.h"
#include "core/model/region.h"
#include "core/model/scene.h"
#include "core/model/stepping.h"
#include "core/model/tissue_model.h"
#include "core/texture/atlas.h"
#include "core/texture/photo_layer.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace esm {

/// Tissue of the whole organ before any region.
struct BaseTissue {
    double springConstant = 0;                    ///< N/m
    double viscosity = 0;                         ///< N·s/m
    double mass = 0;                              ///< kg, total
    std::optional<SpringStiffening> stiffening{}; ///< of all springs, in regions too; linear without
};

/// How the organ got its texture space. The packed atlas is derived from the mesh and these.
struct TextureSettings {
    AtlasOptions atlas;
    std::array<std::uint8_t, 3> baseColour{186, 92, 84}; ///< where no photo lies
};

/// One organ and all that was said about it. A value: a copy costs a few pointers and small lists; an edit
/// makes a new value.
struct Project {
    std::string name;
    std::shared_ptr<const TriangleMesh> mesh; ///< never null; may have no triangle (a pure motion model)
    std::shared_ptr<const RepairReport> importReport; ///< never null
    std::shared_ptr<const SpringNetwork> network;     ///< never null
    BaseTissue base;
    std::vector<Region> regions; ///< from the first to the last; a later one lies over an earlier one
    Scene scene;
    std::optional<MeasuredStepping> stepping; ///< that is recommended; none until measured
    std::vector<PhotoLayer> photos;           ///< from the lowest to the topmost
    TextureSettings texture;
    std::shared_ptr<const Atlas> atlas; ///< null until packed
};

inline constexpr double wallThickness = 0.003; ///< m, that an open surface weighs as

/// A project around an imported or made mesh, with default tissue and tethers that are stable and behave like
/// tissue at any size. Without a mass: closed surface, its volume × 1000 kg/m³; open, area × 3 mm × 1000
/// kg/m³. What moves rigidly hangs on fixed nodes, with the published parameters of the uterus [R C.1].
/// @throws InvalidModel when the mass is not above zero, or the surface has no such level of detail
Project makeProject(std::string name, RepairedMesh surface,
                    std::optional<double> massKilograms = std::nullopt, const Detail& detail = {});

/// What one region came to.
struct RegionResult {
    std::size_t nodes = 0, springs = 0; ///< inside; a spring is inside when both its ends are
    RegionTissue tissue;
};

/// Evaluates regions from the bottom up, then the scene's tethers and fixed nodes.
/// Precondition: the scene is valid for the network.
/// @throws InvalidModel when a region sets inputs that its fuzzy system does not have
TissueModel evaluateModel(const Project& project, const Scene& scene);
inline TissueModel evaluateModel(const Project& project) {
    return evaluateModel(project, project.scene);
}

/// What of a scene has no effect on the model it was evaluated for: ellipsoids that hold no node, forces and
/// paths of fixed nodes. Precondition: the scene is valid for the network.
std::vector<std::string> sceneWarnings(const Scene& scene, const TissueModel& model);

/// Counts and values of one region for reports and panels.
/// @throws InvalidModel when the region sets inputs that its fuzzy system does not have
RegionResult evaluateRegion(const Project& project, const Region& region);

/// Nodes inside a region, in order.
std::vector<std::uint32_t> nodesInside(const SpringNetwork& network, const Region& region);

/// Every problem of the project and its parts. Empty when all is well.
std::vector<std::string> validate(const Project& project);

} // namespace esm
