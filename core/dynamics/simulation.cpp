#include "core/dynamics/simulation.h"

#include "core/dynamics/divergence.h"
#include "core/dynamics/forces.h"
#include "core/dynamics/kernel/thread_team.h"
#include "core/dynamics/schemes/stepper.h"
#include "core/dynamics/stability/stability.h"
#include "core/support/errors.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

namespace {

/// Why the loads cannot act on a model; empty when they can.
std::string problemOf(const Loads& loads, const SpringSystem& system) {
    const std::size_t nodeCount = system.mass.size();
    if (!loads.gravity.allFinite()) return "gravity is not a number";
    for (const auto& [node, force] : loads.forces)
        if (node >= nodeCount || !force.allFinite()) return "a force names no node or is not a number";
    for (const PrescribedNode& led : loads.prescribed)
        if (led.node >= nodeCount || !led.position.allFinite())
            return "a led node does not exist or has no place to go to";
    for (const CavityPressure& pressure : loads.pressures) {
        const auto isMeant = [&](const SpringSystem::Filled& cavity) { return cavity.part == pressure.part; };
        if (std::none_of(system.cavities.begin(), system.cavities.end(), isMeant) ||
            !(std::isfinite(pressure.before) && std::isfinite(pressure.after)))
            return "a pressure is for a part of the surface that is not filled, or is not a number";
    }
    for (const auto& [shape, pose] : loads.instruments)
        if (!(pose.place.allFinite() && pose.orientation.coeffs().allFinite() && radiusOf(shape) > 0 &&
              lengthOf(shape) >= 0))
            return "an instrument has no place or no size";
    return {};
}

/// Looking at where an explicit step led costs as much as the step, and more when most of the tissue rests.
constexpr double judgedTogether = 16, mostJudgedTogether = 1024;

/// Fewer nodes are faster on one thread.
constexpr std::size_t leastForThreads = 2000;

std::unique_ptr<ThreadTeam> makeTeam(std::size_t nodes, const SimulationSettings& settings) {
    const bool usesTeam = isExplicit(settings.integrator) || settings.integrator == Integrator::Auto;
    if (!usesTeam || settings.threads == 1 || nodes < leastForThreads) return nullptr;
    return std::make_unique<ThreadTeam>(settings.threads);
}

} // namespace

struct Simulation::Implementation {
    /// What comes back when the run goes back.
    struct KeptState {
        Motion motion;
        double time; ///< s
        std::vector<ColliderPose> instruments;
        DivergenceGuard guard;
    };

    SimulationSettings settings;
    TouchedSurface surface;
    std::unique_ptr<ThreadTeam> team; ///< null when one thread is enough
    ChosenStep chosen;
    Stepper stepper;
    Motion motion;
    std::size_t steps = 0;
    std::size_t stepsEver = 0; ///< `steps` begins anew with a new model
    double activeSteps = 0;    ///< each step counted by the share of the nodes that it was computed for
    double startTime = 0;      ///< s, before which the step was another
    std::vector<ColliderPose> instruments; ///< where the last step left them
    DivergenceGuard guard;
    std::string failure;
    std::vector<InstrumentTouch> touches; ///< since the start
    double contactWork = 0;               ///< J, of all instruments
    std::optional<KeptState> older, younger;

    /// What the run began with, where its topology is another one now.
    struct Whole {
        SpringSystem system;
        TouchedSurface surface;
    };
    std::optional<Whole> whole;

    Implementation(PreparedModel model, TouchedSurface touchable)
        : settings(model.settings), surface(std::move(touchable)),
          team(makeTeam(model.system.mass.size(), settings)), chosen(model.chosen),
          stepper(std::move(model), surface, team.get()) {
        reset();
    }

    /// Of the tissue that runs or ran, whose network's order of elimination may be known.
    PreparedModel prepared(SpringSystem system, const ChosenStep& step) const {
        return prepareModel(std::move(system), settings, step, stepper.factoriser());
    }

    void reset() {
        if (whole) {
            stepper = Stepper(prepared(whole->system, chosen), whole->surface, team.get());
            surface = std::move(whole->surface);
            whole.reset();
        }
        motion.positions = stepper.system().network->restPositions;
        motion.velocities.assign(motion.positions.size(), Eigen::Vector3d::Zero());
        guard.restart(motion.positions);
        instruments.clear();
        steps = stepsEver = 0;
        activeSteps = 0;
        startTime = 0;
        failure.clear();
        touches.clear();
        contactWork = 0;
        older.reset();
        younger.reset();
        stepper.restart();
    }

    /// Goes on with another stepper, from now on.
    void goOnWith(const ChosenStep& step, Stepper other) {
        startTime = time();
        steps = 0;
        chosen = step;
        stepper = std::move(other);
    }

    void goBack(const KeptState& kept) {
        motion = kept.motion;
        instruments = kept.instruments;
        guard = kept.guard;
        startTime = kept.time;
        steps = 0;
        younger.reset();
    }

    KeptState stateNow() const { return {motion, time(), instruments, guard}; }

    /// Lets the motion, and the states that were kept of it, go on in other tissue. @param map none: of the
    /// same nodes
    void takeOver(const SpringSystem& other, const NodeMap* map = nullptr) {
        const auto take = [&](Motion& taken, DivergenceGuard& its) {
            const double before = esm::energy(stepper.system(), taken.positions, taken.velocities).total();
            if (map) taken = {map->mapped(taken.positions), map->mapped(taken.velocities)};
            for (std::size_t node = 0; node < other.fixed.size(); ++node)
                if (other.fixed[node]) taken.velocities[node].setZero();
            its.allow(std::max(0.0, esm::energy(other, taken.positions, taken.velocities).total() - before));
        };
        take(motion, guard);
        for (std::optional<KeptState>* kept : {&older, &younger})
            if (*kept) take((*kept)->motion, (*kept)->guard);
    }

    double time() const { return startTime + static_cast<double>(steps) * chosen.timeStep; }

    /// The instruments' ways during the next step.
    std::vector<ColliderMove> sweepsTo(const std::vector<PlacedCollider>& places) const {
        std::vector<ColliderMove> moves;
        moves.reserve(places.size());
        for (const auto& [shape, pose] : places)
            moves.push_back(
                {shape, moves.size() < instruments.size() ? instruments[moves.size()] : pose, pose});
        return moves;
    }

    void takeTouches() {
        touches.resize(std::max(touches.size(), stepper.touches().size()));
        for (std::size_t i = 0; i < stepper.touches().size(); ++i) {
            const InstrumentTouch& last = stepper.touches()[i];
            touches[i].impulse += last.impulse;
            touches[i].touched = touches[i].touched || last.touched;
            touches[i].metImmovable = touches[i].metImmovable || last.metImmovable;
        }
    }

    /// Steps `next` on so many times, each by `duration`, s; says why it cannot be right.
    std::string advance(Motion& next, const Loads& loads, double duration, std::size_t count) {
        const std::vector<ColliderMove> sweeps = sweepsTo(loads.instruments);
        stepper.steps(next, {loads, sweeps, duration, count});
        std::vector<double> ways;
        for (const ColliderMove& sweep : sweeps)
            if (ways.size() < instruments.size())
                ways.push_back(mostMotion(sweep.shape, sweep.from, sweep.to));
        return guard.problemOf({stepper.system(), motion.positions, next.positions, next.velocities, loads,
                                ways, static_cast<double>(count) * duration});
    }

    /// False, with the reason, when the state stays as it was. The caller moves the time on.
    bool take(const Loads& loads, double duration, std::size_t count) {
        Motion next = motion;
        try {
            failure = advance(next, loads, duration, count);
        } catch (const std::exception& reason) {
            failure = reason.what();
            stepper.restart();
            throw;
        }
        if (!failure.empty()) {
            stepper.restart();
            return false;
        }
        motion = std::move(next);
        takeTouches();
        contactWork += stepper.contactWork();
        instruments.clear();
        for (const PlacedCollider& placed : loads.instruments)
            instruments.push_back(placed.pose);
        stepsEver += count;
        activeSteps += stepper.activeFraction() * static_cast<double>(count);
        return true;
    }

    Energy energy() const { return esm::energy(stepper.system(), motion.positions, motion.velocities); }
};

Simulation::Simulation(const TissueModel& model, const SimulationSettings& settings, TouchedSurface surface)
    : Simulation(prepareModel(model, settings), std::move(surface)) {}
Simulation::Simulation(PreparedModel model, TouchedSurface surface)
    : m_implementation(std::make_unique<Implementation>(std::move(model), std::move(surface))) {}
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

const Motion& Simulation::motion() const {
    return m_implementation->motion;
}
const SpringSystem& Simulation::system() const {
    return m_implementation->stepper.system();
}

double Simulation::contactWork() const {
    return m_implementation->contactWork;
}

double Simulation::factorisationSeconds() const {
    return m_implementation->stepper.factorisationSeconds();
}

const std::vector<InstrumentTouch>& Simulation::instrumentTouches() const {
    return m_implementation->touches;
}

Energy Simulation::energy() const {
    return m_implementation->energy();
}

double Simulation::activeFraction() const {
    const Implementation& self = *m_implementation;
    return self.stepsEver > 0 ? self.activeSteps / static_cast<double>(self.stepsEver) : 1;
}

bool Simulation::step(const Loads& loads) {
    return advance(loads, 1) == 1;
}

std::size_t Simulation::advance(const Loads& loads, std::size_t count) {
    Implementation& self = *m_implementation;
    self.failure = problemOf(loads, self.stepper.system());
    const bool together = self.stepper.touchesNothing(loads);
    for (std::size_t taken = 0; taken < count && self.failure.empty();) {
        const double worthwhile = judgedTogether / std::max(self.stepper.activeFraction(), 1e-6);
        const auto most = static_cast<std::size_t>(std::min(worthwhile, mostJudgedTogether));
        const std::size_t steps = std::min(together ? most : 1, count - taken);
        if (!self.take(loads, self.chosen.timeStep, steps)) return taken;
        self.steps += steps;
        taken += steps;
    }
    return self.failure.empty() ? count : 0;
}

bool Simulation::stepTo(double time, const Loads& loads) {
    Implementation& self = *m_implementation;
    self.failure = problemOf(loads, self.stepper.system());
    if (!self.failure.empty() || !self.take(loads, time - self.time(), 1)) return false;
    self.startTime = time;
    self.steps = 0;
    return true;
}

void Simulation::placeInstruments(std::vector<ColliderPose> poses) {
    m_implementation->instruments = std::move(poses);
}

void Simulation::setModel(const TissueModel& model) {
    setModel(model, m_implementation->settings);
}

void Simulation::setModel(const TissueModel& model, const SimulationSettings& settings) {
    setModel(prepareModel(model, settings, m_implementation->stepper.factoriser()));
}

void Simulation::setModel(PreparedModel model) {
    Implementation& self = *m_implementation;
    if (model.system.mass.size() != self.motion.positions.size())
        throw InvalidModel("new parameters are for another number of nodes than the running model has");
    if (self.whole) throw InvalidModel("the tissue was cut: put it to rest before it takes new parameters");
    if (!self.team) self.team = makeTeam(model.system.mass.size(), model.settings);
    SimulationSettings settings = model.settings;
    const ChosenStep chosen = model.chosen;
    Stepper stepper(std::move(model), self.surface, self.team.get(), &self.stepper);
    self.takeOver(stepper.system());
    self.settings = std::move(settings);
    self.goOnWith(chosen, std::move(stepper));
    // The motion goes on from here, whatever the parameters: back to here is better than back to rest.
    if (!self.older) self.older = self.younger ? std::exchange(self.younger, {}) : self.stateNow();
}

void Simulation::setTopology(const TissueModel& model, const NodeMap& map, TouchedSurface surface) {
    Implementation& self = *m_implementation;
    SpringSystem system = makeSpringSystem(model);
    if (auto problems = map.problems(self.motion.positions.size(), system.mass.size()); !problems.empty())
        throw InvalidModel(std::move(problems));
    if (!self.team) self.team = makeTeam(system.mass.size(), self.settings);
    Stepper stepper(self.prepared(std::move(system), self.chosen), surface, self.team.get());
    if (!self.whole) self.whole = {self.stepper.system(), self.surface};
    self.takeOver(stepper.system(), &map);
    self.surface = std::move(surface);
    self.goOnWith(self.chosen, std::move(stepper));
}

void Simulation::keepState() {
    Implementation& self = *m_implementation;
    // After going back, the older one is still the calm one.
    if (self.younger) self.older = std::move(self.younger);
    self.younger = self.stateNow();
}

void Simulation::goBack(double timeStep) {
    Implementation& self = *m_implementation;
    const ChosenStep shorter{self.chosen.integrator, timeStep};
    self.goOnWith(shorter, Stepper(self.prepared(self.stepper.system(), shorter), self.surface,
                                   self.team.get(), &self.stepper));
    self.failure.clear();
    if (self.older)
        self.goBack(*self.older);
    else
        self.reset();
}

void Simulation::reset() {
    m_implementation->reset();
}

} // namespace esm
