#include "core/dynamics/hinge_entries.h"

namespace esm {

namespace {

/// The columns of K for one node: what all four are pulled by, a block for each.
std::array<Eigen::Matrix3d, 4> stiffnessOfColumn(const SpringSystem::HingeElement& hinge,
                                                 const BentHinge& bent, HingeTangent tangent,
                                                 std::size_t place) {
    std::array<Eigen::Matrix3d, 4> blocks;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        HingeVectors moved;
        moved.fill(Eigen::Vector3d::Zero());
        moved[place] = Eigen::Vector3d::Unit(axis);
        const HingeVectors forces = stiffnessTimes(hinge, bent, tangent == HingeTangent::WithStrain, moved);
        for (std::size_t i = 0; i < 4; ++i)
            blocks[i].col(axis) = forces[i];
    }
    return blocks;
}

} // namespace

void addHinge(const SpringSystem::HingeElement& hinge, const Vectors& positions, HingeTangent tangent,
              const MatrixFactors& factors, BlockEntries& entries) {
    const BentHinge bent = bentHinge(hinge, ofNodes(hinge, positions));
    for (std::size_t j = 0; j < 4; ++j) {
        const auto stiffness = stiffnessOfColumn(hinge, bent, tangent, j);
        for (std::size_t i = 0; i < 4; ++i)
            entries.add(hinge.nodes[i], hinge.nodes[j],
                        factors.damping * hinge.viscosity * hinge.weights[i] * hinge.weights[j] *
                                Eigen::Matrix3d::Identity() +
                            factors.stiffness * stiffness[i]);
    }
}

} // namespace esm
