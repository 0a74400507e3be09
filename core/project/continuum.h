#pragma once

#include "core/model/equivalent_material.h"
#include "core/project/project.h"

namespace esm {

/// The continuum that an organ's springs stand for: of an even sheet the wall that it makes, of a filled body
/// the body. None of springs that are as stiff as their mesh makes them, of what moves rigidly, and of a bare
/// diamond lattice, which resists no shear, nor of numbers beyond 10³⁰ or below 10⁻³⁰. The density is what
/// weighs as much as the nodes; that of a sheet which carries the mass of a whole organ is above any
/// tissue's.
/// @param tissue of the project, evaluated
std::optional<EquivalentMaterial> continuumOf(const Project& project, const TissueModel& tissue);

} // namespace esm
