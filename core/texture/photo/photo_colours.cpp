#include "core/texture/photo/photo_colours.h"

#include <algorithm>
#include <cstdint>

namespace esm {

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
