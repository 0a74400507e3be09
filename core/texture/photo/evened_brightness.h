#pragma once

#include "core/texture/image.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace esm {

/// A picture's brightness relative to its surroundings, so that pictures of one thing in different light look
/// alike: about 0 everywhere, ±1 where it differs as much as is usual there.
struct EvenedBrightness {
    int width = 0, height = 0;
    std::vector<float> values;
    std::vector<std::uint8_t> counts; ///< 0 where the picture is transparent

    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    }
};

/// @param surroundings what belongs to the surroundings of a pixel, by its alpha; of the picture's size
EvenedBrightness evenedBrightness(const Image& picture, const Image& surroundings);

/// Between the pixels around a place, with the derivative by it.
struct BrightnessAt {
    double value;
    Eigen::Vector2d gradient; ///< per pixel
};

/// Pixels from the top left corner, a pixel's centre at 0.5. Nothing where one of the pixels around does not
/// count.
std::optional<BrightnessAt> brightnessAt(const EvenedBrightness& picture, const Eigen::Vector2d& place);

} // namespace esm
