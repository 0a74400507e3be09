#pragma once

#include <opencv2/core.hpp>

namespace esm {

/// Noise in layers, each with features half as large as those before it, float 0 to 1.
cv::Mat layeredNoise(cv::Size size, double featureSize, int layers, cv::RNG& random);

/// Mucosa with vessels and folds in the uneven light of an endoscope, in some pictures with a lumen and an
/// instrument of grey metal; float, red, green, blue, 0 to 1, without any mirror image.
cv::Mat madeTissue(cv::Size size, int variant, cv::RNG& random);

/// The light of white that the lamp's mirror images add to each pixel: single flecks of 2 to 40 pixels and
/// wet streaks, with soft edges, saturated and not, float.
cv::Mat madeShine(cv::Size size, cv::RNG& random);

} // namespace esm
