#pragma once

#include "core/texture/image.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <optional>
#include <vector>

namespace esm {

/// Where a photo's dark outside meets the picture, for one notion of what is dark. On a reduced photo.
struct FieldBorder {
    cv::Mat outside;                     ///< 255 where the photo is as dark as its corners, 8 bit
    cv::Mat lit;                         ///< 255 on the largest part that is not, 8 bit
    std::vector<Eigen::Vector2d> points; ///< on the border, pixels of the reduced photo
};

/// A photo as fields are looked for in it.
struct ReducedPhoto {
    cv::Mat brightness; ///< the brightest channel, without the noise of single pixels, 8 bit
    cv::Mat burntIn;    ///< 255 where a colour is that no tissue has, as of boxes, 8 bit
    double scale = 1;   ///< pixels of the photo per pixel here
};

/// At most so many pixels across. What is transparent counts as bright: it is left out already.
ReducedPhoto reducedPhoto(const Image& photo, int mostAcross);

/// The level of the dark outside by the photo's corners, or none where no corner is dark and even.
std::optional<int> darkLevel(const cv::Mat& brightness);

/// @param tolerance how far what counts as outside may differ from its level
FieldBorder borderOf(const cv::Mat& brightness, int level, int tolerance);

} // namespace esm
