#pragma once

#include "core/model/stepping.h"

#include <QString>

namespace esm {

/// "8.4 ms", "3.0 µs".
QString durationText(double seconds);

/// "split2, step 8.4 ms", and "single precision" where it is.
QString steppingText(const Stepping& stepping);

/// "viscous split, 10 ms steps".
QString wayText(Integrator integrator, double timeStep);

/// What a stepping method does, in plain words.
QString methodText(Integrator integrator);

} // namespace esm
