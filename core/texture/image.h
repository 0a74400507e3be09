#pragma once

#include <cstdint>
#include <vector>

namespace esm {

/// Pixels in rows from the top, red, green, blue, alpha, each from 0 to the channel's largest value, sRGB,
/// alpha not premultiplied.
template<typename Channel> struct ImageOf {
    int width = 0, height = 0;
    std::vector<Channel> pixels; ///< 4 · width · height

    bool empty() const { return pixels.empty(); }
    Channel* at(int x, int y) {
        return &pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                            static_cast<std::size_t>(x))];
    }
    const Channel* at(int x, int y) const { return const_cast<ImageOf*>(this)->at(x, y); }
};

using Image = ImageOf<std::uint8_t>;
using DeepImage = ImageOf<std::uint16_t>; ///< for what is worked on further

} // namespace esm
