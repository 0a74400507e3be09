#include "core/render/colour_ramp.h"

#include <algorithm>
#include <cmath>

namespace esm {

/// Viridis (N. Smith and S. van der Walt 2015, in the public domain by CC0), sampled at every sixteenth of
/// its length, linear between. Its darkest three sixteenths are left out: thin lines of them vanish on a dark
/// ground.
Colour rampColour(double share) {
    constexpr std::array<Colour, 14> stops{{{66, 64, 134},
                                            {59, 82, 139},
                                            {51, 99, 141},
                                            {44, 114, 142},
                                            {38, 130, 142},
                                            {33, 145, 140},
                                            {31, 160, 136},
                                            {40, 174, 128},
                                            {63, 188, 115},
                                            {94, 201, 98},
                                            {132, 212, 75},
                                            {173, 220, 48},
                                            {216, 226, 25},
                                            {253, 231, 37}}};
    const double place = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
    const double part = place - static_cast<double>(below);
    Colour colour{};
    for (std::size_t i = 0; i < 3; ++i)
        colour[i] =
            static_cast<std::uint8_t>(std::lround((1 - part) * stops[below][i] + part * stops[below + 1][i]));
    return colour;
}

} // namespace esm
