#pragma once

#include "core/geometry/mesh_source.h"
#include "core/geometry/repair.h"
#include "core/model/detail.h"
#include "core/model/scene.h"
#include "core/model/stepping.h"
#include "core/model/tissue_model.h"
#include "core/project/editor_state.h"
#include "core/project/measured_accuracy.h"
#include "core/project/region.h"
#include "core/project/wall.h"
#include "core/texture/atlas/atlas.h"
#include "core/texture/layers/texture_layer.h"

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
    double wallThickness = usualWallThickness;    ///< m, of which spring constants mean Young's moduli
    /// Whether a hollow organ resists bending as that wall does; else it bends freely. A body that is filled
    /// or moves rigidly has no such wall, and no use for it.
    bool resistsBending = false;

    bool operator==(const BaseTissue&) const = default;
};
template<>
inline constexpr auto fieldsOf<BaseTissue> = fieldTable(
    field("springConstant", &BaseTissue::springConstant, amountLimits("the organ's spring constant")),
    field("viscosity", &BaseTissue::viscosity, amountLimits("the organ's viscosity")),
    field("mass", &BaseTissue::mass, massLimits("the organ's mass")),
    field("stiffening", &BaseTissue::stiffening).whenSet(),
    field("wallThickness", &BaseTissue::wallThickness,
          positiveLimits("the wall's thickness", "m", thickestWall))
        .whenSet(),
    field("resistsBending", &BaseTissue::resistsBending).whenSet());

/// s, viscosity over spring constant; none where the constant is 0.
std::optional<double> relaxationTimeOf(const BaseTissue& base);

/// How the organ got its texture space. The packed atlas is derived from the mesh and these.
struct TextureSettings {
    AtlasOptions atlas;
    std::array<std::uint8_t, 3> baseColour{186, 92, 84}; ///< where no photo lies
    std::optional<SurfaceFinish> finish{}; ///< where no layer has one; none: as before version 11
    double occlusionReach = 0;             ///< m, see `occlusionPages`; 0: no ambient occlusion is baked

    bool operator==(const TextureSettings&) const = default;
};
/// Files have it beside the fields of the atlas.
template<>
inline constexpr auto fieldsOf<TextureSettings> = fieldTable(
    field("baseColour", &TextureSettings::baseColour), field("finish", &TextureSettings::finish).whenSet(),
    field("occlusionReach", &TextureSettings::occlusionReach,
          Limits<double>{"the reach of occlusion", 0, farthestOcclusion, "m"})
        .whenSet());

/// One organ and all that was said about it. A value: a copy costs a few pointers and small lists; an edit
/// makes a new value.
struct Project {
    std::string name;
    std::shared_ptr<const TriangleMesh> mesh; ///< never null; may have no triangle (a pure motion model)
    std::shared_ptr<const RepairReport> importReport; ///< never null
    std::shared_ptr<const SpringNetwork> network;     ///< never null
    BaseTissue base;
    std::vector<Region> regions; ///< from the first to the last; a later one lies over an earlier one
    /// Fuzzy systems that no region uses, each once: kept until they are removed. Those that ship with the
    /// program are always at hand, and not stored.
    std::vector<ByValue<FuzzySystem>> spareSystems;
    Scene scene;
    std::optional<MeasuredStepping> stepping; ///< that is recommended; none until measured
    ByValue<MeasuredAccuracy> accuracy;       ///< null until measured
    std::vector<TextureLayer> layers;         ///< from the lowest to the topmost
    TextureSettings texture;
    std::shared_ptr<const Atlas> atlas; ///< null until packed
    std::optional<EditorState> editor;  ///< none until saved by the editor
    std::optional<MeshSource> source{}; ///< that the mesh was imported from; none of what was made otherwise

    bool operator==(const Project&) const = default;
};

/// Gives the regions and the layers of a project that was loaded or made identities, by their places.
void numberParts(Project& project);

/// A project around an imported or made mesh, with default tissue and tethers that are stable and behave like
/// tissue at any size. Without a mass: closed surface, its volume × 1000 kg/m³; open, area × 3 mm × 1000
/// kg/m³. What moves rigidly hangs on fixed nodes, with the published parameters of the uterus [R C.1].
/// @throws InvalidModel when the mass is not above zero, or the surface has no such level of detail;
/// Cancelled
Project makeProject(std::string name, RepairedMesh surface,
                    std::optional<double> massKilograms = std::nullopt, const Detail& detail = {},
                    const Progress& progress = {});

/// The same on a network of the surface, with this mass, kg.
Project projectOn(std::shared_ptr<const SpringNetwork> network, std::string name, RepairedMesh surface,
                  double mass);

/// What a region reaches. A spring is inside when both its ends are, and in the rim when both are inside or
/// in the rim, but not both inside.
struct RegionCount {
    std::size_t nodes = 0, springs = 0;       ///< wholly inside
    std::size_t rimNodes = 0, rimSprings = 0; ///< in the soft rim
};

/// What one region came to.
struct RegionResult : RegionCount {
    RegionTissue tissue;
};

/// Whether the organ is a surface, which a wall's thickness can make resist bending.
bool hasWall(const SpringNetwork& network);

/// Evaluates regions from the bottom up, then the scene's tethers and fixed nodes. In a soft rim the region's
/// spring constant and viscosity mix with those beneath in proportion to its weight w, w·c + (1 − w)·c',
/// which stays between both, is defined down to 0, and is how a spring takes the mean of its ends. Of its
/// mass each node gets what is in proportion to w, all of them together exactly the region's mass (but Σw of
/// it where the weights make less than one node), and keeps (1 − w) of what it weighed beneath.
/// Precondition: the scene is valid for the network.
/// @throws InvalidModel when a region sets inputs that its fuzzy system does not have
TissueModel evaluateModel(const Project& project, const Scene& scene);
inline TissueModel evaluateModel(const Project& project) {
    return evaluateModel(project, project.scene);
}

/// The nodes that a scene fixes, in order, each once.
std::vector<std::uint32_t> fixedNodesOf(const SpringNetwork& network, const Scene& scene);
/// All that a selection names, sorted, each once.
std::vector<std::uint32_t> nodesOf(const SpringNetwork& network, const NodeSelection& selection);

/// What of a scene has no effect on the model it was evaluated for: ellipsoids that hold no node, forces and
/// paths of fixed nodes. Precondition: the scene is valid for the network.
std::vector<std::string> sceneWarnings(const Scene& scene, const TissueModel& model);

/// Counts and values of one region for reports. Its warnings also say what outputs keep that no rule reaches.
/// @throws InvalidModel when the region sets inputs that its fuzzy system does not have
RegionResult evaluateRegion(const Project& project, const Region& region);

/// The region's weight at every node, see `weightAt`.
std::vector<double> nodeWeights(const SpringNetwork& network, const Region& region);

/// Without evaluating the region's tissue.
RegionCount countOf(const SpringNetwork& network, const Region& region);

/// Every problem of the project and its parts. Empty when all is well.
std::vector<std::string> validate(const Project& project);
/// What a project without problems is made of, evaluated once. @throws InvalidModel with all that validate()
/// finds
TissueModel soundModel(const Project& project);

} // namespace esm
