#pragma once

#include "core/model/wall_hinges.h"
#include "tests/support/tissue_models.h"

#include <Eigen/Geometry>

#include <cmath>

/// Walls that resist bending, and how they are bent.
namespace esm::test {

/// The tissue of a mesh, as a wall of this thickness, m.
inline TissueModel wallOf(const TriangleMesh& mesh, const tissue::Parameters& parameters, double thickness) {
    TissueModel model = tissue::fromMesh(mesh, parameters);
    model.hinges = wallHinges(model, mesh.triangles, thickness);
    return model;
}

/// A sheet in the plane z = 0 rolled onto a cylinder of this radius; which way is an angle from x.
inline std::vector<Eigen::Vector3d> rolled(std::vector<Eigen::Vector3d> sheet, double radius, double angle) {
    const Eigen::AngleAxisd turn(angle, Eigen::Vector3d::UnitZ());
    for (Eigen::Vector3d& node : sheet) {
        const Eigen::Vector3d flat = turn.inverse() * node;
        node = turn * Eigen::Vector3d(radius * std::sin(flat.x() / radius), flat.y(),
                                      radius * (1 - std::cos(flat.x() / radius)));
    }
    return sheet;
}

} // namespace esm::test
