#pragma once

#include <opencv2/core.hpp>

namespace esm {

/// Lays one to three pale polyps and organs over tissue, before it is lit: shaded as balls are, with texture
/// and vessels of their own. 25 to 200 pixels across, or in a picture wider than 960 in relation as many.
/// @returns 255 where they are, 8 bit
cv::Mat addPaleObjects(cv::Mat& tissue, cv::RNG& random);

/// The lamp's mirror images on them, which are smaller than they are.
void addFlecksOn(const cv::Mat& objects, cv::Mat& shine, cv::RNG& random);

} // namespace esm
