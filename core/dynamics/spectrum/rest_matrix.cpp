#include "core/dynamics/spectrum/rest_matrix.h"

#include "core/dynamics/block_entries.h"
#include "core/dynamics/hinge_entries.h"

namespace esm {

// At rest no spring has tension, so that none resists being turned: K of a spring is c·n·nᵀ alone. Stretched
// tissue resists more, and bears shorter steps only. What has to hold at any deformation therefore takes the
// Laplacian in its place, which is above K wherever the tissue goes; of hinges that are bent at rest nearly.
Eigen::SparseMatrix<double> restMatrix(const SpringSystem& system, Damping damping,
                                       const MatrixFactors& factors) {
    BlockEntries entries(system.fixed);
    const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
    for (std::uint32_t i = 0; i < system.mass.size(); ++i)
        entries.add(i, i, factors.mass * system.mass[i] * identity);
    const Vectors& rest = system.network->restPositions;
    for (const auto& spring : system.springs) {
        const Eigen::Vector3d direction = (rest[spring.first] - rest[spring.second]).normalized();
        const Eigen::Matrix3d along = direction * direction.transpose();
        const Eigen::Matrix3d damped = damping == Damping::Axial ? along : identity;
        const Eigen::Matrix3d block =
            factors.damping * spring.viscosity * damped + factors.stiffness * spring.springConstant * along;
        entries.addBetween(spring.first, spring.second, block);
    }
    for (const auto& hinge : system.hinges)
        addHinge(hinge, rest, HingeTangent::WithoutStrain, factors, entries);
    for (const Tether& tether : system.tethers)
        entries.add(tether.node, tether.node,
                    (factors.damping * tether.viscosity + factors.stiffness * tether.springConstant) *
                        identity);
    return entries.matrix();
}

} // namespace esm
