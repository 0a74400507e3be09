#pragma once

namespace esm {

/// Pa, in which clinics do not measure.
inline constexpr double pascalPerMillimetreOfMercury = 133.322387415;
inline constexpr double pascalPerCentimetreOfWater = 98.0665;

} // namespace esm
