#include "core/samples/organs.h"

#include "core/support/angles.h"

#include <cmath>

namespace esm {

namespace {

/// Two inner nodes, one above the other, that carry the uterus; each hangs on three fixed outer nodes which
/// stand around it like a tripod, so that it is held in every direction [R 5.1, fig. 5.4].
SpringNetwork motionModel() {
    SpringNetwork network;
    network.restPositions = {{0, 0.015, 0}, {0, -0.015, 0}};
    for (const double side : {1.0, -1.0})
        for (int leg = 0; leg < 3; ++leg) {
            const double angle = 2 * pi * leg / 3 + (side > 0 ? pi / 2 : -pi / 2);
            network.restPositions.emplace_back(0.03 * std::cos(angle), side * 0.035, 0.03 * std::sin(angle));
        }
    const auto tie = [&network](std::uint32_t first, std::uint32_t second) {
        const auto& at = network.restPositions;
        network.springs.push_back({first, second, (at[first] - at[second]).norm()});
    };
    tie(0, 1);
    for (const std::uint32_t outer : {2U, 3U, 4U})
        tie(0, outer);
    for (const std::uint32_t outer : {5U, 6U, 7U})
        tie(1, outer);
    return network;
}

} // namespace

Project makeUterus() {
    Project project = makeProject("Uterus", asImported({}), 0.500);
    project.network = std::make_shared<const SpringNetwork>(motionModel());
    project.regions = {fuzzyRegion("Uterus", "susilap-g", {{"consistency", 10.1}})};
    project.scene.duration = 1.5;
    project.scene.fixed.push_back({{2, 3, 4, 5, 6, 7}, std::nullopt});
    project.scene.forces.push_back({0, {0, 0, -0.3}, 0, 0.5});
    return project;
}

} // namespace esm
