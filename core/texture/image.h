#pragma once

#include <cstdint>
#include <vector>

namespace esm {

/// Pixels in rows from the top, red, green, blue, alpha, 8 bits each, sRGB, alpha not premultiplied.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> pixels; ///< 4 · width · height

    bool empty() const { return pixels.empty(); }
    std::uint8_t* at(int x, int y) {
        return &pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                            static_cast<std::size_t>(x))];
    }
    const std::uint8_t* at(int x, int y) const { return const_cast<Image*>(this)->at(x, y); }
};

} // namespace esm
