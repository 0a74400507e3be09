#include "core/probing/press_curve.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double longestStride = 0.25; ///< in radii: tissue must not come to lie on the finger's other side

} // namespace

// Each depth begins where the one before came to rest, as a finger that goes on slowly would have it. Where
// tissue can fold in several ways, that keeps to one of them; elsewhere the way there changes nothing.
std::vector<PressPoint> pressCurve(PressedTissue& tissue, double depth, int steps, const Progress& progress) {
    std::vector<PressPoint> curve{{0, 0}};
    const double stride = depth / steps;
    const int parts = std::max(1, static_cast<int>(std::ceil(stride / (longestStride * tissue.radius()))));
    const int all = steps * parts;
    for (int i = 1; i <= all; ++i) {
        reportProgress(progress, static_cast<double>(i - 1) / all);
        tissue.settle(AtDepth{depth * i / all});
        if (i % parts == 0) curve.push_back({tissue.depth(), tissue.force()});
    }
    return curve;
}

} // namespace esm
