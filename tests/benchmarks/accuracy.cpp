#include "tests/benchmarks/accuracy.h"

#include "core/dynamics/stability/stability.h"
#include "tests/support/tissue_models.h"

#include <stdexcept>

namespace benchmarks {

PulledTissue pulledMembrane(double largestFrequency, double damping, const Eigen::Vector3d& force,
                            double seconds) {
    constexpr int side = 37;
    constexpr double springConstant = 100; // N/m
    esm::TissueModel model = tissue::fromMesh(tissue::gridMesh(side, 0.1), {springConstant, 0, 1});
    for (std::uint32_t node = 0; node < side * side; ++node)
        if (node % side == 0 || node % side == side - 1 || node / side == 0 || node / side == side - 1)
            model.fixedNodes.push_back(node);
    const double frequency = esm::largestAngularFrequency(model);
    const double mass = frequency * frequency / (largestFrequency * largestFrequency);
    model.mass.assign(model.mass.size(), mass);
    model.viscosity.assign(model.mass.size(), damping * springConstant / largestFrequency);
    return {std::move(model), side * side / 2, force, seconds};
}

esm::Trajectory trajectoryOf(const PulledTissue& tissue, esm::Integrator integrator, int steps) {
    esm::SimulationSettings settings;
    settings.integrator = integrator;
    settings.timeStep = tissue.seconds / steps;
    settings.threads = 1;
    esm::Simulation simulation(tissue.model, settings);
    esm::Loads loads;
    loads.forces = {{tissue.node, tissue.force}};
    esm::Trajectory trajectory{{0, simulation.positions()}};
    const auto together = static_cast<std::size_t>(steps / frameCount);
    for (long frame = 1; frame <= frameCount && simulation.advance(loads, together) == together; ++frame)
        trajectory[frame] = simulation.positions();
    return trajectory;
}

double errorOf(const esm::Trajectory& found, const esm::Trajectory& reference) {
    if (found.size() < reference.size()) return std::numeric_limits<double>::infinity();
    return esm::relativeError(found, reference);
}

int fewestSteps(const PulledTissue& tissue, esm::Integrator integrator, double mostError,
                const esm::Trajectory& reference) {
    for (int steps = frameCount; steps < 100000; steps *= 2)
        if (errorOf(trajectoryOf(tissue, integrator, steps), reference) <= mostError) return steps;
    throw std::runtime_error("no number of steps is accurate enough");
}

} // namespace benchmarks
