#pragma once

#include <functional>

namespace esm {

/// Of forces that are left, over those that are sought: then tissue is at rest.
inline constexpr double balanced = 1e-6;
/// The same where rounding lets nothing more be gained, or after many steps down a valley with next to no
/// slope, as of a net that shears freely or is slack: the force is known long before the place is.
inline constexpr double nearlyBalanced = 1e-4;

/// Goes downhill until so little is left; false where it finds no such place.
/// @param left of forces where it stands, over those that are sought
/// @param go as much of a way as lowers the potential; false where none does
bool findRest(double tolerance, const std::function<double()>& left, const std::function<bool()>& go);

} // namespace esm
