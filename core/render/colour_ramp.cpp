#include "core/render/colour_ramp.h"

#include <algorithm>
#include <cmath>

namespace esm {

Colour rampColour(double share) {
    constexpr std::array<Colour, 5> stops{
        {{47, 75, 156}, {46, 143, 179}, {79, 184, 150}, {232, 200, 79}, {226, 93, 77}}};
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
