#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/model/tissue_model.h"

#include <vector>

namespace esm {

/// N·m, by which a wall resists bending: E·t³ / 12(1 − ν²), of a net of springs of this constant, N/m, which
/// makes a sheet of E·t = 2c/√3 and ν = 1/3. @param thickness t, m
double plateStiffness(double springConstant, double thickness);

/// The hinges that bend as a wall of this thickness, m: one for each edge of two triangles, of the mean
/// tissue of its four nodes, which relaxes in the same time d/c bent as stretched. Edges where the surface
/// ends or branches bend freely, as do those where there is no tissue or a triangle has no area.
/// Precondition: `triangles` are over the model's nodes.
std::vector<Hinge> wallHinges(const TissueModel& model, const std::vector<Triangle>& triangles,
                              double thickness);

} // namespace esm
