#include "core/dynamics/simulation.h"

#include "core/dynamics/forces.h"
#include "core/dynamics/stepper.h"
#include "core/support/errors.h"

#include <cmath>

namespace esm {

namespace {

/// Farther from each other than this many times the model's size, nodes have left all bounds.
constexpr double mostSpread = 100;

double spread(const Vectors& positions) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& position : positions)
        mean += position;
    mean /= static_cast<double>(positions.size());
    double farthest = 0;
    for (const Eigen::Vector3d& position : positions) {
        const double distance = (position - mean).norm();
        if (!(distance <= farthest)) farthest = distance; // not-a-number stays
        if (std::isnan(distance)) return distance;
    }
    return farthest;
}

bool isFinite(const Vectors& vectors) {
    for (const Eigen::Vector3d& vector : vectors)
        if (!vector.allFinite()) return false;
    return true;
}

/// Why the loads cannot act on a model; empty when they can.
std::string problemOf(const Loads& loads, std::size_t nodeCount) {
    if (!loads.gravity.allFinite()) return "gravity is not a number";
    for (const auto& [node, force] : loads.forces)
        if (node >= nodeCount || !force.allFinite()) return "a force names no node or is not a number";
    for (const HeldNode& held : loads.held)
        if (held.node >= nodeCount || !held.position.allFinite())
            return "a led node does not exist or has no place to go to";
    if (loads.instrument && !(loads.instrument->centre.allFinite() && loads.instrument->radius > 0))
        return "the instrument has no place or no size";
    return {};
}

} // namespace

struct Simulation::Implementation {
    SimulationSettings settings;
    std::vector<Triangle> surface;
    ChosenStep chosen;
    Stepper stepper;
    Motion motion;
    std::size_t steps = 0;
    double startTime = 0; ///< s, before which the step was another
    double size = 0;      ///< m
    std::string failure;

    Implementation(const TissueModel& model, const SimulationSettings& given, std::vector<Triangle> triangles)
        : settings(given), surface(std::move(triangles)), chosen(chooseStep(model, given)),
          stepper(makeSpringSystem(model), surface, chosen, given.damping) {
        reset();
    }

    void reset() {
        motion.positions = stepper.system().network->restPositions;
        motion.velocities.assign(motion.positions.size(), Eigen::Vector3d::Zero());
        size = motion.positions.empty() ? 0 : spread(motion.positions);
        steps = 0;
        startTime = 0;
        failure.clear();
        stepper.restart();
    }

    double time() const { return startTime + static_cast<double>(steps) * chosen.timeStep; }

    /// Why a motion cannot be right; empty when it can.
    std::string problemOf(const Motion& next) const {
        if (next.positions.empty()) return {};
        if (!isFinite(next.positions) || !isFinite(next.velocities))
            return "the motion grew beyond all numbers";
        if (size > 0 && spread(next.positions) > mostSpread * size)
            return "the tissue flew apart, to more than a hundred times its size";
        return {};
    }
};

Simulation::Simulation(const TissueModel& model, const SimulationSettings& settings,
                       std::vector<Triangle> surface)
    : m_implementation(std::make_unique<Implementation>(model, settings, std::move(surface))) {}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

Integrator Simulation::integrator() const {
    return m_implementation->chosen.integrator;
}
double Simulation::timeStep() const {
    return m_implementation->chosen.timeStep;
}
double Simulation::time() const {
    return m_implementation->time();
}
const std::vector<Eigen::Vector3d>& Simulation::positions() const {
    return m_implementation->motion.positions;
}
const std::vector<Eigen::Vector3d>& Simulation::velocities() const {
    return m_implementation->motion.velocities;
}
const std::string& Simulation::failure() const {
    return m_implementation->failure;
}

Energy Simulation::energy() const {
    const Motion& motion = m_implementation->motion;
    return esm::energy(m_implementation->stepper.system(), motion.positions, motion.velocities);
}

bool Simulation::step(const Loads& loads) {
    Implementation& self = *m_implementation;
    self.failure = problemOf(loads, self.motion.positions.size());
    if (!self.failure.empty()) return false;
    Motion next = self.motion;
    self.stepper.step(next, loads);
    self.failure = self.problemOf(next);
    if (!self.failure.empty()) {
        self.stepper.restart();
        return false;
    }
    self.motion = std::move(next);
    ++self.steps;
    return true;
}

void Simulation::setModel(const TissueModel& model) {
    Implementation& self = *m_implementation;
    SpringSystem system = makeSpringSystem(model);
    if (system.mass.size() != self.motion.positions.size())
        throw InvalidModel("new parameters are for another number of nodes than the running model has");
    const ChosenStep chosen = chooseStep(model, self.settings);
    Stepper stepper(std::move(system), self.surface, chosen, self.settings.damping);
    self.startTime = self.time();
    self.steps = 0;
    self.chosen = chosen;
    self.stepper = std::move(stepper);
    for (std::uint32_t node : model.fixedNodes)
        self.motion.velocities[node].setZero();
}

void Simulation::reset() {
    m_implementation->reset();
}

} // namespace esm
