#pragma once

#include "core/dynamics/loads.h"
#include "core/dynamics/spring_system.h"
#include "core/support/progress.h"

namespace esm {

/// Tissue as it rests under pressures from within.
struct InflatedTissue {
    Vectors positions; ///< m
    std::vector<CavityPressure> pressures;
};

/// Where tissue comes to from rest while the pressures rise slowly from nothing. Without a pressure it is at
/// rest.
/// @param system where parts that nothing holds are fixed
/// @param pressures each the same before and after
/// @throws InvalidModel where they burst a part, or where no balance is found
/// @throws Cancelled
InflatedTissue inflated(const SpringSystem& system, std::vector<CavityPressure> pressures,
                        const Progress& progress = {});

} // namespace esm
