#include "core/dynamics/simulation.h"

#include "core/dynamics/divergence.h"
#include "core/dynamics/forces.h"
#include "core/dynamics/schemes/stepper.h"
#include "core/dynamics/stability/stability.h"
#include "core/support/errors.h"

#include <algorithm>
#include <utility>

namespace esm {

namespace {

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

/// Looking at where an explicit step led costs as much as the step, and more when most of the tissue rests.
constexpr double judgedTogether = 16, mostJudgedTogether = 1024;

/// Fewer nodes are faster on one thread.
constexpr std::size_t leastForThreads = 2000;

std::unique_ptr<ThreadTeam> makeTeam(const TissueModel& model, const SimulationSettings& settings) {
    const bool usesTeam = isExplicit(settings.integrator) || settings.integrator == Integrator::Auto;
    if (!usesTeam || settings.threads == 1 || model.mass.size() < leastForThreads) return nullptr;
    return std::make_unique<ThreadTeam>(settings.threads);
}

} // namespace

struct Simulation::Implementation {
    /// What comes back when the run goes back.
    struct KeptState {
        Motion motion;
        double time; ///< s
        std::optional<Eigen::Vector3d> instrument;
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
    std::optional<Eigen::Vector3d> instrument; ///< m, centre, where the last step left it
    DivergenceGuard guard;
    std::string failure;
    bool touched = false;   ///< by the instrument, since the start
    double contactWork = 0; ///< J, of it
    std::optional<KeptState> older, younger;

    Implementation(const TissueModel& model, const SimulationSettings& given, TouchedSurface touchable)
        : settings(given), surface(std::move(touchable)), team(makeTeam(model, given)),
          chosen(chooseStep(model, given)),
          stepper(makeSpringSystem(model), surface, {chosen, given, team.get()}) {
        reset();
    }

    void reset() {
        motion.positions = stepper.system().network->restPositions;
        motion.velocities.assign(motion.positions.size(), Eigen::Vector3d::Zero());
        guard.restart(motion.positions);
        instrument.reset();
        steps = stepsEver = 0;
        activeSteps = 0;
        startTime = 0;
        failure.clear();
        touched = false;
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
        instrument = kept.instrument;
        guard = kept.guard;
        startTime = kept.time;
        steps = 0;
        younger.reset();
    }

    KeptState stateNow() const { return {motion, time(), instrument, guard}; }

    /// Lets the motion, and the states that were kept of it, go on in tissue with other parameters.
    void takeOver(const SpringSystem& other) {
        const auto take = [&](Motion& taken, DivergenceGuard& its) {
            const double before = esm::energy(stepper.system(), taken.positions, taken.velocities).total();
            for (std::size_t node = 0; node < other.fixed.size(); ++node)
                if (other.fixed[node]) taken.velocities[node].setZero();
            its.allow(std::max(0.0, esm::energy(other, taken.positions, taken.velocities).total() - before));
        };
        take(motion, guard);
        for (std::optional<KeptState>* kept : {&older, &younger})
            if (*kept) take((*kept)->motion, (*kept)->guard);
    }

    double time() const { return startTime + static_cast<double>(steps) * chosen.timeStep; }

    /// The instrument's way during the next step, if there is one.
    std::optional<SphereMove> sweepTo(const std::optional<Sphere>& sphere) const {
        if (!sphere) return std::nullopt;
        return SphereMove{instrument.value_or(sphere->centre), sphere->centre, sphere->radius};
    }

    /// Steps `next` on so many times, each by `duration`, s; says why it cannot be right.
    std::string advance(Motion& next, const Loads& loads, double duration, std::size_t count) {
        const std::optional<SphereMove> sweep = sweepTo(loads.instrument);
        stepper.steps(next, {loads, sweep, duration, count});
        std::optional<double> way;
        if (sweep && instrument) way = (sweep->to - sweep->from).norm();
        return guard.problemOf({stepper.system(), motion.positions, next.positions, next.velocities, loads,
                                way, static_cast<double>(count) * duration});
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
        touched = touched || stepper.isTouched();
        contactWork += stepper.contactWork();
        instrument.reset();
        if (loads.instrument) instrument = loads.instrument->centre;
        stepsEver += count;
        activeSteps += stepper.activeFraction() * static_cast<double>(count);
        return true;
    }

    Energy energy() const { return esm::energy(stepper.system(), motion.positions, motion.velocities); }
};

Simulation::Simulation(const TissueModel& model, const SimulationSettings& settings, TouchedSurface surface)
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

bool Simulation::wasTouched() const {
    return m_implementation->touched;
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
    self.failure = problemOf(loads, self.motion.positions.size());
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
    self.failure = problemOf(loads, self.motion.positions.size());
    if (!self.failure.empty() || !self.take(loads, time - self.time(), 1)) return false;
    self.startTime = time;
    self.steps = 0;
    return true;
}

void Simulation::placeInstrument(const Eigen::Vector3d& centre) {
    m_implementation->instrument = centre;
}

void Simulation::setModel(const TissueModel& model) {
    setModel(model, m_implementation->settings);
}

void Simulation::setModel(const TissueModel& model, const SimulationSettings& settings) {
    Implementation& self = *m_implementation;
    SpringSystem system = makeSpringSystem(model);
    if (system.mass.size() != self.motion.positions.size())
        throw InvalidModel("new parameters are for another number of nodes than the running model has");
    const ChosenStep chosen = chooseStep(model, settings);
    if (!self.team) self.team = makeTeam(model, settings);
    Stepper stepper(std::move(system), self.surface, {chosen, settings, self.team.get()}, &self.stepper);
    self.takeOver(stepper.system());
    self.settings = settings;
    self.goOnWith(chosen, std::move(stepper));
    // The motion goes on from here, whatever the parameters: back to here is better than back to rest.
    if (!self.older) self.older = self.younger ? std::exchange(self.younger, {}) : self.stateNow();
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
    self.goOnWith(shorter, Stepper(self.stepper.system(), self.surface,
                                   {shorter, self.settings, self.team.get()}, &self.stepper));
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
