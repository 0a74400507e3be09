#include "core/texture/photo/photo_colours.h"

#include <algorithm>
#include <cstdint>

namespace esm {

/// That the world is grey on average does not hold in the body, where all is red: gains for that would turn
/// tissue grey. What is nearly grey already, as instruments, gauze and shine, shows the lamp's colour. Its
/// pixels count by (1 − saturation / 0.4)², so that the limit is no step; dark ones are noise, and of burnt
/// out ones a channel is cut off.
std::optional<ColourGains> findWhiteBalance(const Image& photo) {
    constexpr int tooDark = 24, tooBright = 240;
    constexpr int strongestColour = 40; ///< percent of the brightest channel
    std::array<double, 3> sums{};
    std::uint64_t counted = 0, seen = 0;
    for (std::size_t i = 0; i < photo.pixels.size(); i += 4) {
        const std::uint8_t* pixel = &photo.pixels[i];
        if (pixel[3] == 0) continue;
        ++seen;
        const auto [least, most] = std::minmax({int{pixel[0]}, int{pixel[1]}, int{pixel[2]}});
        if (least < tooDark || most > tooBright || 100 * (most - least) > strongestColour * most) continue;
        ++counted;
        // 1 for grey, 0 where a pixel is as coloured as may be.
        const double grey = 1 - 100.0 * (most - least) / (strongestColour * most);
        for (std::size_t channel = 0; channel < 3; ++channel)
            sums[channel] += grey * grey * pixel[channel];
    }
    if (100 * counted < seen || !(sums[0] > 0)) return std::nullopt;
    ColourGains gains{};
    for (std::size_t channel = 0; channel < 3; ++channel)
        gains[channel] = std::clamp(sums[1] / sums[channel], 0.5, 2.0);
    return gains;
}

void multiplyColours(Image& photo, const ColourGains& gains) {
    std::array<std::array<std::uint8_t, 256>, 3> values{};
    for (std::size_t channel = 0; channel < 3; ++channel)
        for (std::size_t value = 0; value < 256; ++value)
            values[channel][value] = static_cast<std::uint8_t>(
                std::clamp(static_cast<double>(value) * gains[channel] + 0.5, 0.0, 255.0));
    for (std::size_t i = 0; i < photo.pixels.size(); i += 4)
        for (std::size_t channel = 0; channel < 3; ++channel)
            photo.pixels[i + channel] = values[channel][photo.pixels[i + channel]];
}

} // namespace esm
