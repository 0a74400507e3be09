#pragma once

#include "core/probing/probe.h"

namespace esm {

/// What a finger that stays at a depth meets once it stands there. What dampers bear while it moves ends with
/// its motion, is often many times larger, and is left out.
struct StandingFinger {
    std::vector<TimedPress> points; ///< by time
    TimedPress largest;             ///< where the force is largest, and the way to the end begins
};
/// @param relaxation of at least one point after the finger stands
StandingFinger standingFinger(const TimeCurve& relaxation);

/// Whether the force hardly falls any more once the finger stands, so that no time could be told of it.
bool hasNextToNoWay(const TimeCurve& relaxation);

/// s, on the clock of the curve: when 1/e of the way to the end is left. None without a time constant.
std::optional<double> fallenAt(const TimeCurve& relaxation);

} // namespace esm
