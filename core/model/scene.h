#pragma once

#include "core/geometry/collider.h"
#include "core/geometry/ellipsoid.h"

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

/// Springs that tie every n-th node (0, n, 2n, …) to its rest position: the surrounding tissue. [R 5.1]
struct TetherRule {
    std::uint32_t every = 3;
    double springConstant = 0; ///< N/m
    double viscosity = 0;      ///< N·s/m

    bool operator==(const TetherRule&) const = default;
};

struct NodeForce {
    std::uint32_t node;
    Eigen::Vector3d force; ///< N
    double from, to;       ///< s; acts for from ≤ t < to

    bool operator==(const NodeForce&) const = default;
};

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

struct Recording {
    double every = 0.01;                             ///< s
    std::optional<std::vector<std::uint32_t>> nodes; ///< all without

    bool operator==(const Recording&) const = default;
};

/// What happens to the model in a run: boundary conditions, loads and what is recorded.
struct Scene {
    double duration = 1;                               ///< s
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero(); ///< m/s²
    std::vector<NodeSelection> fixed;
    std::vector<TetherRule> tethers;
    std::vector<NodeForce> forces;
    std::vector<NodeMove> moves;
    std::vector<InstrumentMotion> instruments;
    Recording record;

    bool operator==(const Scene&) const = default;
};

/// Where a path is at a time. Precondition: the path has a point.
Eigen::Vector3d positionAt(const Path& path, double time);

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

/// Every problem of a scene for a model of `nodeCount` nodes. Empty when it can run.
std::vector<std::string> validate(const Scene& scene, std::size_t nodeCount);

} // namespace esm
