#pragma once

#include "core/dynamics/schemes/scheme.h"
#include "core/model/integrators.h"

#include <stdexcept>

namespace esm {

/// Each in the file of its name.
extern const Scheme eulerScheme, verletScheme, heunScheme, rk4Scheme, adamsMoultonScheme, propagationScheme,
    implicitScheme, bdf2Scheme, projectiveScheme, splitScheme, split2Scheme, trapezoidScheme;

/// Precondition: not `Auto`, which steps nothing. The switch is without a default, so that the compiler finds
/// the forgotten.
inline const Scheme& schemeOf(Integrator integrator) {
    switch (integrator) {
    case Integrator::Auto:
        break;
    case Integrator::Euler:
        return eulerScheme;
    case Integrator::Verlet:
        return verletScheme;
    case Integrator::Heun:
        return heunScheme;
    case Integrator::Rk4:
        return rk4Scheme;
    case Integrator::AdamsMoulton:
        return adamsMoultonScheme;
    case Integrator::Propagation:
        return propagationScheme;
    case Integrator::Implicit:
        return implicitScheme;
    case Integrator::Bdf2:
        return bdf2Scheme;
    case Integrator::Projective:
        return projectiveScheme;
    case Integrator::Split:
        return splitScheme;
    case Integrator::Split2:
        return split2Scheme;
    case Integrator::Trapezoid:
        return trapezoidScheme;
    }
    throw std::logic_error("an integrator without a scheme was asked for its step");
}

} // namespace esm
