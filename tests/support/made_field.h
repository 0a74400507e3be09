#pragma once

#include <opencv2/core.hpp>

#include <string>

namespace esm {

/// How an endoscope's picture lies in its frame.
struct MadeField {
    std::string name;
    cv::Size frame;
    cv::Mat mask;  ///< 255 inside
    cv::Mat share; ///< the same with a smooth edge of a pixel, float 0 to 1
};

constexpr int madeFieldKinds = 10;

/// @param kind from 0: whole circle, circle cut by one to four sides, ellipse, octagon, rounded rectangle,
/// none, a shape that is larger than the frame
MadeField madeField(int kind, int variant, cv::RNG& random);

} // namespace esm
