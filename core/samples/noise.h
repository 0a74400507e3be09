#pragma once

#include <cstdint>

namespace esm {

/// A number of 0 to 1 for a place of an integer grid, the same on every machine.
double gridNoise(int x, int y, std::uint32_t seed);

/// Smooth noise of 0 to 1 with features one unit wide.
double smoothNoise(double x, double y, std::uint32_t seed);

/// Sum of smooth noises, each of half the size and strength of the one before, 0 to 1.
double layeredNoise(double x, double y, int octaves, std::uint32_t seed);

} // namespace esm
