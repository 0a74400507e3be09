#pragma once

#include "core/model/lattice.h"

#include <Eigen/Core>

namespace esm {

/// Stress over strain of an endless lattice at small strain, in Voigt's order xx, yy, zz, yz, zx, xy with
/// shears counted twice. Relative: of springs of constant 1 N/m between nearest neighbours 1 m apart, Pa; of
/// constant c and spacing h it is c/h times that.
struct LatticeElasticity {
    Eigen::Matrix<double, 6, 6> tensor;

    /// Stiffness in shear along the cube's faces over that across them (Zener 1948): 1 where the lattice is
    /// isotropic.
    double anisotropy() const;
    double bulkModulus() const;
    /// Of the isotropic solid that is nearest to it (Voigt's mean over all directions).
    double youngsModulus() const;
    double poissonsRatio() const;
};

/// Springs have forces along themselves alone, so that ν is 1/4 wherever each site is a centre of symmetry
/// (Cauchy). Cubic: E = 5c/(2a). Body-centred: E = 5c/(3a), a being the cube's edge. Diamond's anisotropy is
/// 2 whatever the share of its second neighbours: its nearest ones resist compression alone, and a
/// face-centred lattice has 2.
/// Precondition: no prisms, which repeat nowhere.
LatticeElasticity elasticityOf(LatticeKind kind);

/// Young's modulus of the solid that a lattice stands for, relative as above. A bare diamond lattice has
/// none; it stands for the solid of ν = 1/4 with its bulk modulus.
double relativeModulus(LatticeKind kind);

/// The constant with which a lattice stands for a solid, N/m: between nearest neighbours; of a wall of prisms
/// that of the regular triangular net which is as stiff, c = √3·t·E/2.
/// @param youngsModulus Pa
double latticeConstant(const LatticeFilling& filling, double youngsModulus);

} // namespace esm
