#pragma once

#include <opencv2/core.hpp>

namespace esm {

using TissueColour = cv::Vec3f; ///< red, green, blue, 0 to 1

/// 0 up to `from`, 1 beyond `to`, smooth between them.
cv::Mat smoothStep(const cv::Mat& values, double from, double to);

/// The same in each of three channels.
cv::Mat inThree(const cv::Mat& one);

/// Changes the colours to another one by a share, float 0 to 1.
void mixIn(cv::Mat& colours, const TissueColour& other, const cv::Mat& share);

/// Noise in layers, each with features half as large as those before it, float 0 to 1.
cv::Mat layeredNoise(cv::Size size, double featureSize, int layers, cv::RNG& random);

/// Lines that wind, join and end like vessels, float 0 to 1.
cv::Mat vessels(cv::Size size, double apart, double width, cv::RNG& random);

/// Mucosa with vessels and folds, in some pictures with a lumen and an instrument of grey metal; float, red,
/// green, blue, 0 to 1, in even light and without any mirror image.
cv::Mat madeTissue(cv::Size size, int variant, cv::RNG& random);

/// The lamp lights a part more than the rest, and the rim least, as an endoscope's does.
void lightUnevenly(cv::Mat& tissue, cv::RNG& random);

/// Adds one mirror image so many pixels across.
void addFleck(cv::Mat& shine, cv::Point at, double size, cv::RNG& random);

/// The light of white that the lamp's mirror images add to each pixel: single flecks of 2 to 40 pixels and
/// wet streaks, with soft edges, saturated and not, float.
cv::Mat madeShine(cv::Size size, cv::RNG& random);

} // namespace esm
