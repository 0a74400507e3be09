#include "core/solid/lattice_elasticity.h"

#include "core/solid/unit_cell.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace esm {

namespace {

using VoigtVector = Eigen::Matrix<double, 6, 1>;

/// How much a direction lengthens per unit of each strain.
VoigtVector lengthening(const Eigen::Vector3d& e) {
    VoigtVector result;
    result << e.x() * e.x(), e.y() * e.y(), e.z() * e.z(), e.y() * e.z(), e.z() * e.x(), e.x() * e.y();
    return result;
}

/// Of a symmetric matrix that may have directions without stiffness.
Eigen::MatrixXd pseudoInverse(const Eigen::MatrixXd& matrix) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    const double least = 1e-9 * solver.eigenvalues().cwiseAbs().maxCoeff();
    const Eigen::VectorXd inverted =
        solver.eigenvalues().unaryExpr([&](double value) { return value > least ? 1 / value : 0.0; });
    return solver.eigenvectors() * inverted.asDiagonal() * solver.eigenvectors().transpose();
}

} // namespace

// A uniform strain moves every site with the lattice (Born and Huang 1954). Where a site is no centre of
// symmetry, as in diamond, sites of one kind then shift against those of the other until their springs
// balance, the same in every cell. The energy of a cell is quadratic in strain and shifts; what is left of
// the strain's part once the shifts have gone to their minimum (a Schur complement) is the tensor.
LatticeElasticity elasticityOf(LatticeKind kind) {
    const UnitCell& cell = unitCellOf(kind);
    const auto shifts = static_cast<Eigen::Index>(3 * cell.sites.size());
    Eigen::Matrix<double, 6, 6> ofStrain = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::MatrixXd mixed = Eigen::MatrixXd::Zero(6, shifts),
                    ofShifts = Eigen::MatrixXd::Zero(shifts, shifts);
    for (const CellSpring& spring : cell.springs) {
        const Eigen::Vector3d along = cell.placeOf(spring.second) - cell.sites[spring.first];
        const Eigen::Vector3d direction = along.normalized();
        const VoigtVector strain = along.norm() * lengthening(direction);
        Eigen::VectorXd shift = Eigen::VectorXd::Zero(shifts);
        shift.segment<3>(3 * Eigen::Index{spring.second.site}) += direction;
        shift.segment<3>(3 * Eigen::Index{spring.first}) -= direction;
        ofStrain += spring.constant * strain * strain.transpose();
        mixed += spring.constant * strain * shift.transpose();
        ofShifts += spring.constant * shift * shift.transpose();
    }
    const double volume = cell.edge * cell.edge * cell.edge;
    return {(ofStrain - mixed * pseudoInverse(ofShifts) * mixed.transpose()) / volume};
}

double LatticeElasticity::bulkModulus() const {
    return (tensor(0, 0) + 2 * tensor(0, 1)) / 3;
}

double LatticeElasticity::anisotropy() const {
    return 2 * tensor(3, 3) / (tensor(0, 0) - tensor(0, 1));
}

// Voigt (1889): the mean of a tensor over all directions has the bulk modulus (C11 + 2·C12)/3 and the shear
// modulus (C11 − C12 + 3·C44)/5 of a cubic one. Where the lattice is isotropic it is the lattice itself.
double LatticeElasticity::youngsModulus() const {
    const double bulk = bulkModulus();
    const double shear = (tensor(0, 0) - tensor(0, 1) + 3 * tensor(3, 3)) / 5;
    return 9 * bulk * shear / (3 * bulk + shear);
}

double LatticeElasticity::poissonsRatio() const {
    const double bulk = bulkModulus();
    const double shear = (tensor(0, 0) - tensor(0, 1) + 3 * tensor(3, 3)) / 5;
    return (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear));
}

double relativeModulus(LatticeKind kind) {
    const LatticeElasticity elasticity = elasticityOf(kind);
    return kind == LatticeKind::BareDiamond ? 1.5 * elasticity.bulkModulus() : elasticity.youngsModulus();
}

double latticeConstant(const LatticeFilling& filling, double youngsModulus) {
    if (isWall(filling)) return std::sqrt(3.0) / 2 * filling.wallThickness * youngsModulus;
    return youngsModulus * filling.spacing / relativeModulus(filling.kind);
}

} // namespace esm
