#include "core/samples/implicit_surface.h"
#include "core/samples/organs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace esm {

namespace {

struct AxisPoint {
    Eigen::Vector3d place; ///< m; x to the side, y up, z to the front
    double radius;         ///< m
};

constexpr std::size_t coursePoints = 8;

/// From the frontal horn back over the body to the atrium, then down and forward into the temporal horn.
const std::array<AxisPoint, coursePoints> course{{{{0.000, 0.006, 0.040}, 0.0030},
                                                  {{0.002, 0.014, 0.027}, 0.0072},
                                                  {{0.003, 0.018, 0.008}, 0.0060},
                                                  {{0.005, 0.015, -0.013}, 0.0070},
                                                  {{0.010, 0.004, -0.029}, 0.0092},
                                                  {{0.016, -0.010, -0.027}, 0.0064},
                                                  {{0.020, -0.018, -0.013}, 0.0046},
                                                  {{0.019, -0.021, 0.006}, 0.0028}}};
const RoundCone occipitalHorn{{0.010, 0.004, -0.029}, {0.0125, 0.003, -0.039}, 0.0088, 0.0064};

AxisPoint courseAt(int index) {
    constexpr int last = coursePoints - 1;
    const int inside = std::clamp(index, 0, last);
    const int towards = std::clamp(inside, 1, last - 1);
    const AxisPoint& end = course[static_cast<std::size_t>(inside)];
    const Eigen::Vector3d onward = end.place - course[static_cast<std::size_t>(towards)].place;
    return {end.place + std::abs(index - inside) * onward, end.radius};
}

/// A smooth line through the course (Catmull and Rom); `place` 0 is its first point, 1 its second. It goes on
/// straight beyond both tips.
AxisPoint smoothAt(double place) {
    const int segment = static_cast<int>(std::floor(place));
    const AxisPoint a = courseAt(segment - 1), b = courseAt(segment), c = courseAt(segment + 1),
                    d = courseAt(segment + 2);
    const double u = place - segment;
    const auto through = [u](const auto& p, const auto& q, const auto& r, const auto& s) {
        return (q + 0.5 * u * (r - p + u * (2 * p - 5 * q + 4 * r - s + u * (3 * (q - r) + s - p)))).eval();
    };
    const auto number = [](double value) { return Eigen::Matrix<double, 1, 1>(value); };
    return {through(a.place, b.place, c.place, d.place),
            through(number(a.radius), number(b.radius), number(c.radius), number(d.radius))[0]};
}

/// The cavity as round cones so short that no joint shows.
std::vector<RoundCone> cavityCones() {
    constexpr int perSegment = 4;
    std::vector<RoundCone> cones;
    for (int i = 1; i <= perSegment * static_cast<int>(coursePoints - 1); ++i) {
        const AxisPoint from = smoothAt(double(i - 1) / perSegment), to = smoothAt(double(i) / perSegment);
        cones.push_back({from.place, to.place, from.radius, to.radius});
    }
    return cones;
}

TriangleMesh ventricleSurface() {
    const std::vector<RoundCone> cones = cavityCones();
    const Shape shape = [&cones](const Eigen::Vector3d& point) {
        double cavity = roundConeDistance(point, cones[0]);
        for (const RoundCone& cone : cones)
            cavity = std::min(cavity, roundConeDistance(point, cone));
        return joined(cavity, roundConeDistance(point, occipitalHorn), 0.006);
    };
    constexpr double beyond = 0.5; // of a segment, more than a tip's radius
    const auto axisAt = [](double t) { return smoothAt(t * (coursePoints - 1 + 2 * beyond) - beyond).place; };
    return meshAround(shape, {axisAt, Eigen::Vector3d::UnitX()}, 0.0021);
}

} // namespace

Project makeVentricle() {
    Project project = makeProject("Lateral ventricle", asImported(ventricleSurface()), 1.0);
    project.regions = {fuzzyRegion("Ventricle wall", "robo-sim",
                                   {{"consistency", 7.3}, {"sensitiveness", 4.9}, {"shiftability", 3.0}})};
    project.scene.duration = 3;
    project.scene.instruments = {
        pokeOf(*project.mesh,
               {{{0.06, 0.017, 0.008}, -Eigen::Vector3d::UnitX()}, 0.003, 0.004, project.scene.duration})};
    return project;
}

} // namespace esm
