#include "core/dynamics/spring_system.h"

#include "core/support/errors.h"

#include <algorithm>
#include <limits>

namespace esm {

namespace {

SecondPhase secondPhaseOf(const std::optional<SpringStiffening>& law, double springConstant) {
    if (!law) return {};
    return {law->strain, law->factor * springConstant};
}

/// The spring between the bars that gives the hinge its stiffness against a small bending at rest.
SpringSystem::HingeElement elementOf(const Hinge& hinge, const std::vector<Eigen::Vector3d>& restPositions) {
    const auto [weights, restCurvature, opening] = *shapeOf(hinge, restPositions);
    const double perMetre = 1 / (opening * opening);
    return {hinge.nodes, weights, restCurvature, perMetre * hinge.stiffness, perMetre * hinge.viscosity};
}

bool isFixed(const SpringSystem& system, const SpringSystem::HingeElement& hinge) {
    return std::all_of(hinge.nodes.begin(), hinge.nodes.end(),
                       [&](std::uint32_t node) { return system.fixed[node] != 0; });
}

SpringSystem::Filled filled(const Cavity& cavity, const Vectors& rest) {
    auto wall = std::make_shared<const CavityWall>(cavity.triangles);
    const double volume = volumeOf(*wall, placesOf(*wall, rest)).volume;
    return {cavity.part, cavity.stiffness, volume, cavity.largestPressure, std::move(wall)};
}

} // namespace

// The bounds of a step need the case of least damping and most stiffness, so that of each spring's two
// constants the larger one counts. What is between fixed nodes cannot move, and what has no elasticity does
// not swing.
double leastDampingRatio(const SpringSystem& system) {
    double ratio = std::numeric_limits<double>::infinity();
    for (const auto& spring : system.springs)
        if (largestSpringConstant(spring) > 0 && !(system.fixed[spring.first] && system.fixed[spring.second]))
            ratio = std::min(ratio, spring.viscosity / largestSpringConstant(spring));
    for (const auto& hinge : system.hinges)
        if (hinge.springConstant > 0 && !isFixed(system, hinge))
            ratio = std::min(ratio, hinge.viscosity / hinge.springConstant);
    for (const Tether& tether : system.tethers)
        if (tether.springConstant > 0 && !system.fixed[tether.node])
            ratio = std::min(ratio, tether.viscosity / tether.springConstant);
    return ratio;
}

SpringSystem makeSpringSystem(const TissueModel& model) {
    if (auto problems = validate(model); !problems.empty()) throw InvalidModel(std::move(problems));
    SpringSystem system;
    system.network = model.network;
    system.mass = model.mass;
    system.tethers = model.tethers;
    system.springs.reserve(model.network->springs.size());
    for (std::size_t i = 0; i < model.network->springs.size(); ++i) {
        const auto& [first, second, restLength] = model.network->springs[i];
        const auto [springConstant, viscosity] = valuesOf(model, i);
        system.springs.push_back({first, second, restLength, springConstant, viscosity,
                                  secondPhaseOf(model.stiffening, springConstant)});
    }
    system.hinges.reserve(model.hinges.size());
    for (const Hinge& hinge : model.hinges)
        system.hinges.push_back(elementOf(hinge, model.network->restPositions));
    system.fixed.assign(model.mass.size(), 0);
    for (std::uint32_t node : model.fixedNodes)
        system.fixed[node] = 1;
    for (const Cavity& cavity : model.cavities)
        system.cavities.push_back(filled(cavity, model.network->restPositions));
    return system;
}

} // namespace esm
