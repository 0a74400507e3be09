#pragma once

#include "core/model/tissue_model.h"

#include <vector>

namespace esm {

/// Young's modulus of tissue whose springs, as the regular triangular net of a wall, have this constant:
/// E = 2c/(√3·t), Pa; c in N/m, t the wall's thickness in m.
double youngsModulusOfWall(double springConstant, double thickness);

/// Constant and viscosity of every spring of a lattice whose nodes have this tissue: those that give the body
/// the modulus of the tissue and its relaxation time, however fine the lattice is. A spring takes its ends'
/// mean. Empty for a surface of springs.
std::vector<SpringValues> latticeValues(const TissueModel& model);

/// How much of the organ each node stands for, over the mean: of a lattice a quarter of the volume around it,
/// of a surface all alike.
std::vector<double> nodeSizes(const SpringNetwork& network);

} // namespace esm
