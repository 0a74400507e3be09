#pragma once

#include "core/dynamics/statics/pressed_tissue.h"
#include "core/probing/probe.h"

namespace esm {

/// Of the end's value: less is no way that a time could be told of.
inline constexpr double leastWay = 0.01;

/// What a test needs that goes on in time.
struct TimedTest {
    const std::function<PressedTissue()>& fresh; ///< tissue at rest, the finger at depth 0
    double thickness;                            ///< m, of the organ
};

/// Force over time of a finger that stays at a depth. @param end of the same depth at rest
TimeCurve relaxationCurve(const TimedTest& test, const RelaxationTest& wanted, const PressPoint& end,
                          const Progress& progress);

/// Depth over time of a finger under a force. @throws InvalidModel where it goes through the organ
TimeCurve creepCurve(const TimedTest& test, const CreepTest& wanted, const Progress& progress);

} // namespace esm
