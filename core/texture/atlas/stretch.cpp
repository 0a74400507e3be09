#include "core/texture/atlas/stretch.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Of a triangle's longest side squared, an area that is rounding error.
constexpr double noArea = 1e-10;

struct WeightedValue {
    double value, weight;
};

DistortionSpread spreadOf(std::vector<WeightedValue> values) {
    DistortionSpread spread;
    if (values.empty()) return spread;
    std::sort(values.begin(), values.end(),
              [](const WeightedValue& a, const WeightedValue& b) { return a.value < b.value; });
    double weight = 0, sum = 0;
    for (const WeightedValue& each : values) {
        weight += each.weight;
        sum += each.weight * each.value;
    }
    spread.mean = sum / weight;
    spread.percentile95 = spread.worst = values.back().value;
    double within = 0;
    for (const WeightedValue& each : values) {
        within += each.weight;
        // Areas add up with rounding errors: a share of just 95 % counts as such.
        if (within < (0.95 - 1e-9) * weight) continue;
        spread.percentile95 = each.value;
        break;
    }
    return spread;
}

} // namespace

/// A 2 × 2 matrix is the sum of a turn with a scale and a mirrored turn with a scale; its singular values are
/// the sum and the difference of those scales, which needs no eigenvalues and loses no digits.
Stretch stretchOf(const std::array<Eigen::Vector3d, 3>& surface,
                  const std::array<Eigen::Vector2d, 3>& plane) {
    const Eigen::Vector3d a = surface[1] - surface[0], b = surface[2] - surface[0];
    const double longest = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
    const double doubled = a.cross(b).norm();
    if (!(doubled > noArea * longest)) return {};
    Eigen::Matrix2d from, to;
    from << a.norm(), a.dot(b) / a.norm(), 0, doubled / a.norm();
    to << plane[1] - plane[0], plane[2] - plane[0];
    const Eigen::Matrix2d map = to * from.inverse();
    const double turning = std::hypot(map(0, 0) + map(1, 1), map(1, 0) - map(0, 1)) / 2;
    const double mirroring = std::hypot(map(0, 0) - map(1, 1), map(1, 0) + map(0, 1)) / 2;
    const double larger = turning + mirroring, smaller = std::abs(turning - mirroring);
    if (!(smaller > noArea * larger)) return {0, 0, doubled / 2, false};
    return {larger, smaller, doubled / 2, mirroring > turning};
}

DistortionSpread angleSpread(const std::vector<Stretch>& stretches) {
    std::vector<WeightedValue> ratios;
    ratios.reserve(stretches.size());
    for (const Stretch& stretch : stretches)
        if (stretch.larger > 0) ratios.push_back({stretch.larger / stretch.smaller, stretch.area});
    return spreadOf(std::move(ratios));
}

DistortionSpread areaSpread(const std::vector<Stretch>& stretches) {
    double surface = 0, plane = 0;
    for (const Stretch& stretch : stretches) {
        if (!(stretch.larger > 0)) continue;
        surface += stretch.area;
        plane += stretch.area * stretch.larger * stretch.smaller;
    }
    std::vector<WeightedValue> ratios;
    ratios.reserve(stretches.size());
    for (const Stretch& stretch : stretches) {
        if (!(stretch.larger > 0)) continue;
        const double density = stretch.larger * stretch.smaller * surface / plane;
        ratios.push_back({std::max(density, 1 / density), stretch.area});
    }
    return spreadOf(std::move(ratios));
}

} // namespace esm
