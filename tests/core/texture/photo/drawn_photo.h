#pragma once

#include "core/texture/image.h"

#include <array>
#include <cmath>
#include <functional>

namespace esm {

using Channels = std::array<int, 4>;

inline Image drawnPhoto(int width, int height, const std::function<Channels(int, int)>& colourAt) {
    Image image;
    image.width = width;
    image.height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int channel : colourAt(x, y))
                image.pixels.push_back(static_cast<std::uint8_t>(channel));
    return image;
}

inline Channels colourOf(const Image& image, int x, int y) {
    const std::uint8_t* p = image.at(x, y);
    return {p[0], p[1], p[2], p[3]};
}

/// Numbers from 0 to `most` that look random and are the same everywhere.
inline int scattered(int x, int y, int most) {
    const auto mixed =
        static_cast<std::uint32_t>(x) * 2654435761U ^ static_cast<std::uint32_t>(y) * 2246822519U;
    return static_cast<int>((mixed ^ mixed >> 15) % static_cast<std::uint32_t>(most + 1));
}

inline Image roundPhoto(double cx, double cy, double radius) {
    return drawnPhoto(640, 480, [&](int x, int y) -> Channels {
        const bool inside = std::hypot(x + 0.5 - cx, y + 0.5 - cy) < radius;
        const bool instrument = std::abs(x - y) < 25 && x > cx; // dark, across the border
        const int level = inside && !instrument ? 60 + scattered(x, y, 90) : scattered(x, y, 6);
        return {level, level / 2, level / 3, 255};
    });
}

} // namespace esm
