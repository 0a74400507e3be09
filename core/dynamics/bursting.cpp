#include "core/dynamics/bursting.h"

#include "core/dynamics/forces.h"

#include <cmath>

namespace esm {

namespace {

/// Beyond it a wall has given way: of a ball of linear springs the tension holds back ever less from eight
/// times its volume on, where it is twice as wide, and no pressure has a place of rest beyond.
constexpr double mostGrowth = 10;

/// People count from 1, files from 0.
std::string partText(const SpringSystem::Filled& cavity) {
    return "part " + std::to_string(cavity.part + 1) + " of the surface (number " +
           std::to_string(cavity.part) + " in files)";
}

} // namespace

// Suction that no wall bears draws it in, through itself, and swells it on the other side: its volume counts
// below zero then, and is a burst's in size.
std::string burstOf(const SpringSystem& system, const Vectors& positions) {
    const std::vector<double> volumes = volumesOf(system, positions);
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        const SpringSystem::Filled& cavity = system.cavities[i];
        if (std::abs(volumes[i]) <= mostGrowth * cavity.restVolume) continue;
        if (volumes[i] < 0)
            return "suction turned " + partText(cavity) +
                   " inside out and swelled it beyond ten times its volume at rest: let it suck less, or "
                   "raise the spring constant";
        return "the pressure bursts " + partText(cavity) +
               ", more than ten times as large as at rest: lower the pressure, or raise the spring constant";
    }
    return {};
}

} // namespace esm
