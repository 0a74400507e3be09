#pragma once

#include "core/dynamics/measure/measured_runs.h"

#include <QString>

namespace esm {

/// "8.4 ms", "3.0 µs".
QString durationText(double seconds);

/// "viscous split, second order", with "single precision" where it is.
QString methodName(const Stepping& stepping);

/// The method, and in a second line its step.
QString steppingText(const Stepping& stepping);

/// "viscous split, 10 ms steps".
QString wayText(Integrator integrator, double timeStep);

/// What a stepping method does, in plain words.
QString methodText(Integrator integrator);

/// "12× real time" and, in a second line, "0.4 % error".
/// @param error a part of the motion
/// @param isErrorBound the error is that or less
QString figuresText(double realTimeFactor, double error, bool isErrorBound = false);

/// Of a run its method, step and figures, in four lines, with the number of nodes where they are fewer than
/// the organ's.
QString runText(const TradeoffRun& run);

} // namespace esm
