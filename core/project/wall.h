#pragma once

namespace esm {

/// m: of a wall whose thickness nobody has stated, which an open surface weighs as.
inline constexpr double usualWallThickness = 0.003;
inline constexpr double thickestWall = 1; ///< m

/// Young's modulus of tissue whose springs, as the regular triangular net of a wall, have this constant:
/// E = 2c/(√3·t), Pa; c in N/m, t the wall's thickness in m. Poisson's ratio is 1/3 then, as springs of a
/// net have it; those of a lattice with this modulus have 1/4.
double youngsModulusOfWall(double springConstant, double thickness);

/// The other way round: c = √3·t·E/2, N/m.
double springConstantOfWall(double youngsModulus, double thickness);

} // namespace esm
