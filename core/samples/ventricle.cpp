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

/// From the frontal horn back over the body to the atrium, then down and forward into the temporal horn.
const std::array<AxisPoint, 8> course{{{{0.000, 0.006, 0.040}, 0.0030},
                                       {{0.002, 0.014, 0.027}, 0.0072},
                                       {{0.003, 0.018, 0.008}, 0.0060},
                                       {{0.005, 0.015, -0.013}, 0.0070},
                                       {{0.010, 0.004, -0.029}, 0.0092},
                                       {{0.016, -0.010, -0.027}, 0.0064},
                                       {{0.020, -0.018, -0.013}, 0.0046},
                                       {{0.019, -0.021, 0.006}, 0.0028}}};

double ventricleDistance(const Eigen::Vector3d& point) {
    const RoundCone occipitalHorn{course[4].place, {0.013, 0.001, -0.052}, 0.0078, 0.0026};
    double body = roundConeDistance(point, occipitalHorn);
    for (std::size_t i = 1; i < course.size(); ++i)
        body = joined(body,
                      roundConeDistance(point, {course[i - 1].place, course[i].place, course[i - 1].radius,
                                                course[i].radius}),
                      0.004);
    return body;
}

/// A smooth line through the course (Catmull and Rom), prolonged beyond both tips.
Eigen::Vector3d axisAt(double t) {
    constexpr double beyond = 0.5; // of a segment, more than a tip's radius
    const double place = std::clamp(t, 0.0, 1.0) * (double(course.size() - 1) + 2 * beyond) - beyond;
    const auto at = [](int i) -> Eigen::Vector3d {
        constexpr int last = static_cast<int>(course.size()) - 1;
        if (i < 0) return course.front().place + double(-i) * (course[0].place - course[1].place);
        if (i > last)
            return course.back().place + double(i - last) * (course[last].place - course[last - 1].place);
        return course[static_cast<std::size_t>(i)].place;
    };
    const int segment = static_cast<int>(std::floor(place));
    const double u = place - segment;
    const Eigen::Vector3d a = at(segment - 1), b = at(segment), c = at(segment + 1), d = at(segment + 2);
    return b + 0.5 * u * (c - a + u * (2 * a - 5 * b + 4 * c - d + u * (3 * (b - c) + d - a)));
}

TriangleMesh ventricleSurface() {
    return meshAround(ventricleDistance, {axisAt, Eigen::Vector3d::UnitX()}, 0.0021);
}

} // namespace

Project makeVentricle() {
    Project project = makeProject("Lateral ventricle", asImported(ventricleSurface()), 1.0);
    project.regions = {fuzzyRegion("Ventricle wall", "robo-sim",
                                   {{"consistency", 7.3}, {"sensitiveness", 4.9}, {"shiftability", 3.0}})};
    project.scene.duration = 2;
    project.scene.instrument =
        pokeOf(*project.mesh,
               {{{0.06, 0.017, 0.008}, -Eigen::Vector3d::UnitX()}, 0.003, 0.004, project.scene.duration});
    return project;
}

} // namespace esm
