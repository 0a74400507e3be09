#pragma once

#include "core/texture/image.h"
#include "core/texture/photo/photo_colours.h"

#include <opencv2/core.hpp>

#include <cstdint>
#include <string>

namespace esm {

constexpr int madePhotoCount = 60;

/// A photo as an endoscope could have taken it, made by code, and what is true of it.
struct MadePhoto {
    std::string name;        ///< what is special about it
    Image image;             ///< as it was taken
    Image withoutFlecks;     ///< the same without the lamp's mirror images
    Image balanced;          ///< the same with the colour of the lamp taken away
    bool fillsFrame = false; ///< there is no field
    ColourGains cast{};      ///< what the lamp multiplies colours with, green 1
    cv::Mat field;           ///< 255 where the field is, 8 bit
    cv::Mat overlays;        ///< 255 where text or a box is burnt in, 8 bit
    cv::Mat pale;            ///< 255 where a pale polyp or organ lies, which is no fleck, 8 bit
    cv::Mat shine;           ///< by how much of 1 flecks make a pixel brighter, float
};

/// One of the sixty, the same on every machine for the same seed: six of each way in which a field lies in
/// the frame, with tissue, light, flecks, text, noise and JPEG of their own, a third with pale objects.
/// @param index from 0
MadePhoto madePhoto(int index, std::uint64_t seed);

} // namespace esm
