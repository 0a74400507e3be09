#pragma once

#include "core/model/tissue_model.h"

#include <vector>

namespace esm {

/// Constant and viscosity of every spring of a network whose nodes have this tissue and share it out, as an
/// even sheet or a lattice does: those that give the organ the modulus of the tissue and its relaxation time,
/// however fine the mesh is. A spring takes its share of its ends' mean. Empty where every spring takes that
/// mean as it is.
/// @param wallThickness m, of which a constant means a modulus
std::vector<SpringValues> sharedValues(const TissueModel& model, double wallThickness);

/// How much of the organ each node stands for, over the mean: of a lattice by the volume around it, of an
/// even sheet by the area, of another surface all alike.
std::vector<double> nodeSizes(const SpringNetwork& network);

} // namespace esm
