#pragma once

#include "core/texture/photo/photo_field.h"

#include <opencv2/core.hpp>

#include <optional>
#include <vector>

namespace esm {

using FieldPoints = std::vector<Eigen::Vector2d>;

/// The circle, or the ellipse, that most of the points lie on, within `tolerance` pixels. The same for the
/// same points. Nothing where there is none of a size and place that fit a photo of `size`.
std::optional<PhotoField> circleThrough(const FieldPoints& points, cv::Size size, double tolerance);
std::optional<PhotoField> ellipseThrough(const FieldPoints& points, cv::Size size, double tolerance);

/// The polygon without dents around the lit part, each of its sides moved to the points along it.
/// @param lit 255 inside, 8 bit
std::optional<PhotoField> polygonAround(const cv::Mat& lit, const FieldPoints& points, double tolerance);

} // namespace esm
