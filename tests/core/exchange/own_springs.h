#pragma once

#include "core/exchange/simulators/handover.h"

namespace esm {

/// The project's tissue with springs of which no project knows: two of three are not their ends' mean.
inline Handover withOwnSprings(const Project& project) {
    Handover handover = handoverOf(project);
    std::vector<SpringValues> values = springValues(handover.tissue);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i % 3 == 0) values[i].springConstant /= 2;
        if (i % 3 == 1) values[i].viscosity *= 1.25;
    }
    handover.tissue.ownValues = std::move(values);
    return handover;
}

} // namespace esm
