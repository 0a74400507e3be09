#pragma once

#include <Eigen/Core>

#include <vector>

namespace esm {

using PhotoOutline = std::vector<Eigen::Vector2d>; ///< corners of a closed line, in photo pixels

/// The outline with as few corners as leave it within `detail` pixels of where it ran (Douglas and Peucker
/// 1973, Algorithms for the reduction of the number of points required to represent a digitized line).
PhotoOutline simplified(const PhotoOutline& outline, double detail);

/// The share of each pixel, 0 to 1, that lies within the outline, row by row; what it goes around several
/// times or in both directions at once lies within as well.
std::vector<float> coverOf(const PhotoOutline& outline, int width, int height);
/// The same of the rows from one to before another.
std::vector<float> coverOf(const PhotoOutline& outline, int width, int firstRow, int endRow);

/// The same of one row.
std::vector<float> rowCoverOf(const PhotoOutline& outline, int width, int y);

} // namespace esm
