#pragma once

#include "core/geometry/collider.h"
#include "core/geometry/edge_path.h"
#include "core/geometry/ellipsoid.h"
#include "core/support/fields.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace esm {

struct NodeSelection {
    std::vector<std::uint32_t> nodes;
    std::optional<Ellipsoid> ellipsoid; ///< at rest; added to `nodes`

    bool operator==(const NodeSelection&) const = default;
};
template<>
inline constexpr auto
    fieldsOf<NodeSelection> = fieldTable(field("nodes", &NodeSelection::nodes).mayBeAbsent(),
                                         field("ellipsoid", &NodeSelection::ellipsoid).whenSet());

/// Springs that tie every n-th node (0, n, 2n, …) to its rest position: the surrounding tissue. [R 5.1] Of a
/// filled organ every n-th at the surface, each by the area around it.
struct TetherRule {
    std::uint32_t every = 3;
    double springConstant = 0; ///< N/m
    double viscosity = 0;      ///< N·s/m

    bool operator==(const TetherRule&) const = default;
};
template<>
inline constexpr auto fieldsOf<TetherRule> =
    fieldTable(field("every", &TetherRule::every,
                     Limits<std::uint32_t>{"every", 1, std::numeric_limits<std::uint32_t>::max()}),
               field("spring_constant", &TetherRule::springConstant, amountLimits("spring_constant", "N/m")),
               field("viscosity", &TetherRule::viscosity, amountLimits("viscosity", "N·s/m")));

struct NodeForce {
    std::uint32_t node = 0;
    Eigen::Vector3d force = Eigen::Vector3d::Zero(); ///< N
    double from = 0, to = 0;                         ///< s; acts for from ≤ t < to

    bool operator==(const NodeForce&) const = default;
};
template<>
inline constexpr auto fieldsOf<NodeForce> =
    fieldTable(field("node", &NodeForce::node), field("force", &NodeForce::force, finiteLimits("the force")),
               field("from", &NodeForce::from).mayBeAbsent(), field("to", &NodeForce::to).mayBeAbsent());

struct PathPoint {
    double time;           ///< s
    Eigen::Vector3d value; ///< m

    bool operator==(const PathPoint&) const = default;
};
using Path = std::vector<PathPoint>; ///< times strictly increasing; linear between, constant outside

/// A node led along a path of displacements from its rest position.
struct NodeMove {
    std::uint32_t node;
    Path path;

    bool operator==(const NodeMove&) const = default;
};
template<>
inline constexpr auto fieldsOf<NodeMove> = fieldTable(field("node", &NodeMove::node),
                                                      field("path", &NodeMove::path));

inline constexpr std::size_t mostFluids =
    16; ///< in a list; a step that solves takes a solution more for each

/// A closed part of the organ that fluid fills and keeps to its volume, as a bladder's or a cyst's does: the
/// pressure in it rises by the stiffness times the share by which it is pressed together.
struct FluidFilling {
    std::uint32_t part =
        0; ///< among the connected ones of the simulated surface, in the order of their triangles
    double stiffness = 0; ///< Pa

    bool operator==(const FluidFilling&) const = default;
};
template<>
inline constexpr auto fieldsOf<FluidFilling> = fieldTable(field("part", &FluidFilling::part),
                                                          field("stiffness", &FluidFilling::stiffness,
                                                                positiveLimits("the stiffness of the fluid",
                                                                               "Pa", largestNumber)));

struct PressurePoint {
    double time;     ///< s
    double pressure; ///< Pa

    bool operator==(const PressurePoint&) const = default;
};

/// What presses from within on a closed part, beside its filling: a balloon's pressure [R C.3].
struct PartPressure {
    std::uint32_t part = 0;          ///< as of a filling
    std::vector<PressurePoint> path; ///< times strictly increasing; linear between, constant outside

    bool operator==(const PartPressure&) const = default;
};
template<>
inline constexpr auto fieldsOf<PartPressure> = fieldTable(field("part", &PartPressure::part),
                                                          field("path", &PartPressure::path));

inline constexpr std::size_t longestInstrumentName = 100; ///< bytes

/// A rigid instrument that pushes the surface.
struct InstrumentMotion {
    Collider shape;
    Path path; ///< of its origin, in model coordinates
    /// One per point of the path, of length 1, own axes to model; turned evenly between, the shorter way
    /// round. None where it is never turned.
    std::vector<Eigen::Quaterniond> orientations;
    std::string name; ///< empty: by its place in the list, see nameOf()

    bool operator==(const InstrumentMotion&) const = default;
};

/// The surface parts along edges: see `splitAlong()`. Edges of later splits may name nodes that earlier ones
/// made.
struct SurfaceSplit {
    double time = 0; ///< s
    EdgePath edges;

    bool operator==(const SurfaceSplit&) const = default;
};
template<>
inline constexpr auto fieldsOf<SurfaceSplit> = fieldTable(field("time", &SurfaceSplit::time,
                                                                amountLimits("time", "s")),
                                                          field("edges", &SurfaceSplit::edges));

struct Recording {
    double every = 0.01;                             ///< s
    std::optional<std::vector<std::uint32_t>> nodes; ///< all without

    bool operator==(const Recording&) const = default;
};
template<>
inline constexpr auto fieldsOf<Recording> =
    fieldTable(field("every", &Recording::every, positiveLimits("record.every", "s")).mayBeAbsent(),
               field("nodes", &Recording::nodes).mayBeAbsent());

/// What happens to the model in a run: boundary conditions, loads and what is recorded.
struct Scene {
    double duration = 1;                               ///< s
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero(); ///< m/s²
    std::vector<NodeSelection> fixed;
    std::vector<TetherRule> tethers;
    std::vector<NodeForce> forces;
    std::vector<NodeMove> moves;
    std::vector<InstrumentMotion> instruments;
    std::vector<FluidFilling> fillings;
    std::vector<PartPressure> pressures;
    std::vector<SurfaceSplit> splits; ///< in any order; those of the same time one after the other
    Recording record;

    bool operator==(const Scene&) const = default;
};
/// Its instruments stand in files in two ways, see `scene_file.cpp`.
template<>
inline constexpr auto fieldsOf<Scene> =
    fieldTable(field("duration", &Scene::duration, positiveLimits("duration", "s")),
               field("gravity", &Scene::gravity, finiteLimits("gravity")).mayBeAbsent(),
               field("fixed", &Scene::fixed).whenSet(), field("tethers", &Scene::tethers).whenSet(),
               field("forces", &Scene::forces).whenSet(), field("moves", &Scene::moves).whenSet(),
               field("fillings", &Scene::fillings).whenSet(), field("pressures", &Scene::pressures).whenSet(),
               field("split", &Scene::splits).whenSet(), field("record", &Scene::record).mayBeAbsent());

/// Where a path is at a time. Precondition: the path has a point.
Eigen::Vector3d positionAt(const Path& path, double time);

/// Pa, at a time. Precondition: the path has a point.
double pressureAt(const PartPressure& pressure, double time);

/// Whether it is the same from the beginning on, as of an organ that stands under a pressure.
inline bool isConstant(const PartPressure& pressure) {
    return pressure.path.size() == 1;
}

/// Where an instrument is at a time. Precondition: its path has a point.
ColliderPose poseAt(const InstrumentMotion& instrument, double time);
PlacedCollider placedAt(const InstrumentMotion& instrument, double time);

/// "instrument 0" and so on for those without a name of their own.
std::string nameOf(const Scene& scene, std::size_t instrument);

/// Whether all of its instruments are what there was before scenes had several: at most one, a sphere without
/// a name that is not turned.
bool hasPlainInstrument(const Scene& scene);

/// "forces[2]": how a scene file names the third force.
std::string sceneEntry(const char* list, std::size_t index);

/// Every problem of a scene for a model of `nodeCount` nodes that can be told without its surface. Loads and
/// what is recorded may name nodes that splits may make.
std::vector<std::string> validate(const Scene& scene, std::size_t nodeCount);

} // namespace esm
