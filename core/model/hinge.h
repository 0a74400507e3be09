#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace esm {

/// Two triangles that share an edge, and resist being bent about it. How far they are bent at rest, the
/// network's rest positions say.
struct Hinge {
    std::array<std::uint32_t, 4> nodes; ///< both ends of the edge, then the corner on either side of it
    double stiffness;                   ///< N·m for each radian
    double viscosity;                   ///< N·m·s for each radian

    bool operator==(const Hinge&) const = default;
};

/// How a hinge lies at rest, told by two bars: its edge, and the line between its other corners. Where these
/// pass each other most closely, their distance says how far the hinge is bent: none while it is flat.
struct HingeShape {
    /// By which the nodes' places sum up to the vector from the edge to the other bar; together 0.
    std::array<double, 4> weights;
    double restCurvature; ///< 1/m, that vector at rest in parts of the cross product of both bars
    double opening;       ///< m, by which the vector departs from rest for each radian of bending
};

/// Empty where the hinge has no such shape: a triangle without area, or one that lies on the other.
/// Precondition: the nodes exist.
std::optional<HingeShape> shapeOf(const Hinge& hinge, const std::vector<Eigen::Vector3d>& restPositions);

/// Every problem of hinges between nodes that rest at these places.
std::vector<std::string> hingeProblems(const std::vector<Hinge>& hinges,
                                       const std::vector<Eigen::Vector3d>& restPositions);

} // namespace esm
