#pragma once

#include "core/project/project.h"

namespace esm {

/// What stays as it was where an organ becomes larger or smaller.
enum class KeptByScaling {
    Mass,   ///< the tissue's numbers: masses (kg), spring constants (N/m) and viscosities (N·s/m)
    Density ///< mass per volume: masses grow with the cube of the factor; N/m and N·s/m stay
};

/// The organ so many times as large, about the origin, with all that lies in its space: rest positions and
/// rest lengths, regions and rims, instruments and paths, landmarks, strokes, projectors, and the texels per
/// metre of its texture the other way. Forces (N) and gravity (m/s²) stay. A measured stepping stays and is
/// known to be from other tissue. A node that lies on an ellipsoid's surface may come to its other side by
/// rounding.
/// @throws InvalidModel where the factor is not above 0, or what comes of it has problems
Project scaled(const Project& project, double factor, KeptByScaling kept = KeptByScaling::Mass);

/// By which a distance between two points (m) becomes a true length (m). @throws InvalidModel where one of
/// both is not above 0
double scaleFactor(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double trueLength);

} // namespace esm
