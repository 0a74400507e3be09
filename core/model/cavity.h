#pragma once

#include "core/geometry/triangle_mesh.h"

#include <string>
#include <vector>

namespace esm {

/// A closed part of the simulated surface, with fluid in it: a bladder, a ventricle, a cyst. The fluid
/// presses alike on all of its wall. It has no mass of its own and does not flow.
struct Cavity {
    /// Its number among the connected parts of the simulated surface, in the order of their first triangles.
    std::uint32_t part = 0;
    std::vector<Triangle> triangles; ///< over nodes, facing out of the fluid
    double stiffness =
        0; ///< Pa, that the fluid's pressure falls by per relative growth of its volume; 0: none
    /// Pa, either way, that loads will lay on it at most; steps are chosen for it.
    double largestPressure = 0;
    double initialPressure = 0; ///< Pa, that they lay on it as the scene begins; no larger either way

    bool operator==(const Cavity&) const = default;
};

/// One part of a surface over nodes at rest, in m, as a cavity of no stiffness.
/// @throws InvalidModel where there is no such part, where it is open (and how far), turns its inside out or
/// encloses nothing
Cavity cavityOf(const std::vector<Eigen::Vector3d>& restPositions, const std::vector<Triangle>& surface,
                std::uint32_t part);

/// Why triangles can be no wall of a fluid, as what is said of them: " is open, …". Empty when they can,
/// facing either way. m
std::string wallProblem(const TriangleMesh& wall);

/// Every problem of a cavity, its part left as it is named.
std::vector<std::string> validate(const Cavity& cavity, const std::vector<Eigen::Vector3d>& restPositions);

} // namespace esm
