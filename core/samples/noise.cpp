#include "core/samples/noise.h"

#include <cmath>

namespace esm {

/// A hash of the place (multiplications and shifts, as hash tables finish their keys) and no generator with a
/// state: any place can be asked for in any order, and pictures are the same on every machine.
double gridNoise(int x, int y, std::uint32_t seed) {
    std::uint32_t bits = seed * 0x9e3779b9U + static_cast<std::uint32_t>(x) * 0x85ebca6bU;
    bits = (bits ^ bits >> 15) * 0x2c1b3c6dU + static_cast<std::uint32_t>(y) * 0xc2b2ae35U;
    bits = (bits ^ bits >> 12) * 0x297a2d39U;
    bits = (bits ^ bits >> 15) * 0x846ca68bU;
    return (bits ^ bits >> 16) / 4294967295.0;
}

/// Values at whole places, eased between them by Perlin's polynomial of the fifth degree (2002), whose second
/// derivative is 0 at its ends: light on bumps then shows no grid.
double smoothNoise(double x, double y, std::uint32_t seed) {
    const double left = std::floor(x), top = std::floor(y);
    const int column = static_cast<int>(left), row = static_cast<int>(top);
    const auto eased = [](double t) { return t * t * t * (t * (6 * t - 15) + 10); };
    const double u = eased(x - left), v = eased(y - top);
    const double above = (1 - u) * gridNoise(column, row, seed) + u * gridNoise(column + 1, row, seed);
    const double below =
        (1 - u) * gridNoise(column, row + 1, seed) + u * gridNoise(column + 1, row + 1, seed);
    return (1 - v) * above + v * below;
}

double layeredNoise(double x, double y, int octaves, std::uint32_t seed) {
    double sum = 0, strength = 1, total = 0;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += strength * smoothNoise(x, y, seed + static_cast<std::uint32_t>(octave));
        total += strength;
        strength /= 2;
        // turned as well as shrunk, or the grid's directions would show
        const double turned = 1.6 * x - 1.2 * y;
        y = 1.2 * x + 1.6 * y;
        x = turned;
    }
    return sum / total;
}

} // namespace esm
