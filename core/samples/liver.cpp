#include "core/samples/implicit_surface.h"
#include "core/samples/organs.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// A liver seen from the front: x to its own left, y up, z to the front; m. The right lobe is large and domed
/// under the diaphragm, the left lobe flat and tapering, the underside hollow, the lower margin notched.
double liverDistance(const Eigen::Vector3d& p) {
    const double rightLobe = ellipsoidDistance(p, {-0.044, 0.000, -0.004}, {0.071, 0.069, 0.051});
    const double rightTip = ellipsoidDistance(p, {-0.068, -0.040, 0.004}, {0.042, 0.044, 0.034});
    const double middle = ellipsoidDistance(p, {0.018, 0.016, 0.008}, {0.056, 0.046, 0.036});
    const double leftLobe = ellipsoidDistance(p, {0.064, 0.028, 0.013}, {0.050, 0.028, 0.021});
    double body = joined(rightLobe, rightTip, 0.040);
    body = joined(body, middle, 0.040);
    body = joined(body, leftLobe, 0.036);

    const double underside = ellipsoidDistance(p, {0.014, -0.088, -0.042}, {0.080, 0.080, 0.070});
    const double notch = roundConeDistance(p, {{0.024, -0.047, 0.070}, {0.018, -0.036, 0.000}, 0.017, 0.010});
    const double gallbladderBed =
        roundConeDistance(p, {{-0.020, -0.078, 0.040}, {-0.004, -0.016, -0.010}, 0.013, 0.008});
    const double venaCava =
        roundConeDistance(p, {{0.000, -0.100, -0.064}, {0.004, 0.100, -0.052}, 0.016, 0.016});
    const double stomach = ellipsoidDistance(p, {0.092, -0.020, -0.020}, {0.054, 0.046, 0.040});
    body = carved(body, underside, 0.020);
    body = carved(body, stomach, 0.014);
    body = carved(body, venaCava, 0.018);
    body = carved(body, gallbladderBed, 0.014);
    body = carved(body, notch, 0.010);

    // The falciform ligament's line from the notch to the dome, on the front only.
    const double aside = (p.x() - 0.016 + 0.10 * p.y()) / 0.006;
    return body + (p.z() > 0 ? 0.0016 * std::exp(-aside * aside) * std::min(p.z() / 0.02, 1.0) : 0.0);
}

TriangleMesh liverSurface() {
    const Axis axis{
        [](double t) { return Eigen::Vector3d(-0.122 + 0.240 * t, -0.014 + 0.044 * t, -0.004 + 0.018 * t); },
        Eigen::Vector3d::UnitY()};
    return meshAround(liverDistance, axis, 0.0056);
}

} // namespace

Project makeLiver() {
    Project project = makeProject("Liver", asImported(liverSurface()), 1.5);
    Region softer = fuzzyRegion("Right lobe, soft", "susilap-g", {{"consistency", 2.5}});
    softer.colour = {224, 164, 88};
    softer.ellipsoid =
        Ellipsoid{{-0.062, 0.004, 0.020}, {0.050, 0.046, 0.050}, Eigen::Quaterniond::Identity()};
    project.regions = {fuzzyRegion("Liver", "susilap-g", {{"consistency", 5.5}}), softer};

    // Held where it has grown to the diaphragm and where its vessels come in, at the back.
    NodeSelection back;
    back.ellipsoid = Ellipsoid{{0.000, 0.020, -0.050}, {0.030, 0.040, 0.022}, Eigen::Quaterniond::Identity()};
    project.scene.fixed.push_back(back);
    project.scene.duration = 3;
    project.scene.instruments = {
        pokeOf(*project.mesh,
               {{{-0.055, 0.005, 0.2}, -Eigen::Vector3d::UnitZ()}, 0.010, 0.020, project.scene.duration})};
    return project;
}

} // namespace esm
