#include "app/editor/workers/preview_run.h"

#include "core/dynamics/forces.h"
#include "core/dynamics/measure/scene_loads.h"
#include "core/render/drawn_shape.h"
#include "core/support/errors.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int mostHalvings = 4;
/// Keeping the state costs little, but not nothing.
constexpr int framesBetweenStates = 15;
/// Of an instrument in the hand: twice what surgeons' reach.
constexpr double fastestHand = 1; // m/s

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What the scene leads, the first `led`, the hand cannot hold.
void letGoOfLedNodes(std::vector<PrescribedNode>& prescribed, std::size_t led) {
    const auto firstOfHand = prescribed.begin() + static_cast<std::ptrdiff_t>(led);
    const auto isLed = [&](const PrescribedNode& node) {
        return std::any_of(prescribed.begin(), firstOfHand,
                           [&](const PrescribedNode& other) { return other.node == node.node; });
    };
    prescribed.erase(std::remove_if(firstOfHand, prescribed.end(), isLed), prescribed.end());
}

} // namespace

bool PreviewRun::take(PreparedProject prepared) {
    const std::shared_ptr<const SpringNetwork> network = prepared.project.network;
    m_modelFailure = prepared.failure;
    try {
        if (prepared.model) run(std::move(prepared));
    } catch (const std::exception& error) {
        m_modelFailure = reasonOf(error);
    }
    if (!m_simulation) m_network = network;
    return m_modelFailure.empty();
}

void PreviewRun::run(PreparedProject prepared) {
    const Project& project = prepared.project;
    const SimulationSettings settings = prepared.model->settings;
    const bool goesOn = m_simulation && m_network == project.network;
    if (goesOn)
        m_simulation->setModel(std::move(*prepared.model));
    else
        m_simulation.emplace(std::move(*prepared.model), touchedSurface(*project.mesh, *project.network));
    m_model = std::move(prepared.tissue);
    m_network = project.network;
    m_settings = settings;
    m_isShortened = project.stepping && *settings.timeStep < project.stepping->stepping.timeStep;
    if (goesOn && m_playsScene && m_scene.moves != project.scene.moves) leaveScene(); // led nodes would jump
    m_scene = project.scene;
    m_gentlePull = std::move(prepared.gentlePull);
    if (!goesOn) {
        m_pull.reset();
        m_heldInstrument.reset();
        m_gentleGrasp.reset();
        m_gentleTime = 0;
        m_playsScene = false;
    }
    m_halvings = 0;
    m_replaced = Replaced::Not;
    m_runFailure.clear();
}

void PreviewRun::reset() {
    m_playsScene = false;
    m_instrumentForce.clear();
    m_pullForce.clear();
    m_pull.reset();
    m_gentleGrasp.reset();
    m_gentleTime = 0;
    m_debt = 0;
    m_runFailure.clear();
    if (!m_simulation) return;
    const bool ranWild = m_halvings > 0 || m_replaced == Replaced::RanWild;
    if (ranWild) m_simulation->setModel(*m_model, m_settings);
    if (ranWild) m_replaced = Replaced::Not;
    m_halvings = 0;
    m_simulation->reset();
}

void PreviewRun::beginScene() {
    reset();
    if (!m_simulation) return;
    m_playsScene = true;
    std::vector<ColliderPose> starts;
    for (const PlacedCollider& instrument : sceneInstruments())
        starts.push_back(instrument.pose);
    m_simulation->placeInstruments(std::move(starts));
}

std::vector<PlacedCollider> PreviewRun::sceneInstruments() const {
    std::vector<PlacedCollider> placed;
    if (!m_playsScene) return placed;
    for (const InstrumentMotion& instrument : m_scene.instruments)
        placed.push_back(placedAt(instrument, m_simulation->time()));
    return placed;
}

/// What comes by hand then stands in the list of instruments where the scene's stood.
void PreviewRun::leaveScene() {
    m_playsScene = false;
    m_simulation->placeInstruments({});
}

bool PreviewRun::isSceneOver() const {
    return m_simulation->time() >= m_scene.duration - m_simulation->timeStep() / 2;
}

Loads PreviewRun::sceneLoads() const {
    const double now = m_simulation->time();
    if (m_playsScene)
        return loadsDuring(m_scene, m_network->restPositions, now, now + m_simulation->timeStep());
    // What is there from the beginning on belongs to the organ, whether or not its scene plays.
    Loads loads;
    loads.gravity = m_scene.gravity;
    for (const PartPressure& pressure : m_scene.pressures)
        if (isConstant(pressure))
            loads.pressures.push_back({pressure.part, pressureAt(pressure, now), pressureAt(pressure, now)});
    return loads;
}

const std::vector<Eigen::Vector3d>& PreviewRun::positions() const {
    static const std::vector<Eigen::Vector3d> none;
    if (m_simulation) return m_simulation->positions();
    return m_network ? m_network->restPositions : none;
}

std::vector<double> PreviewRun::speeds() const {
    std::vector<double> speeds;
    if (!m_simulation) return speeds;
    speeds.reserve(m_simulation->velocities().size());
    for (const Eigen::Vector3d& velocity : m_simulation->velocities())
        speeds.push_back(velocity.norm());
    return speeds;
}

void PreviewRun::followLoads(const PreviewLoads& loads) {
    if (!loads.pull)
        m_pull.reset();
    else if (!m_pull || m_pull->node() != loads.pull->node)
        m_pull.emplace(*m_model, m_simulation->positions(), loads.pull->node);
    if (m_pull) m_pull->setTarget(loads.pull->target);

    if (!loads.gentleMotion || !m_gentlePull)
        m_gentleGrasp.reset();
    else if (!m_gentleGrasp)
        m_gentleGrasp.emplace(*m_model, m_simulation->positions(), m_gentlePull->node);
}

/// One that comes is where the hand has it at once.
void PreviewRun::leadInstrument(const std::optional<PlacedCollider>& target) {
    const std::optional<PlacedCollider> before = std::exchange(m_heldInstrument, target);
    if (!before || !target) return;
    const double way = mostMotion(target->shape, before->pose, target->pose);
    const double longest = fastestHand * m_simulation->timeStep();
    if (way > longest) m_heldInstrument->pose = between(before->pose, target->pose, longest / way);
}

bool PreviewRun::step(const PreviewLoads& loads) {
    const double timeStep = m_simulation->timeStep();
    Loads acting = sceneLoads();
    leadInstrument(loads.instrument);
    if (m_heldInstrument) acting.instruments.push_back(*m_heldInstrument);
    const std::size_t led = acting.prescribed.size();
    if (m_pull) m_pull->advance(timeStep, acting.prescribed);
    if (m_gentleGrasp) {
        m_gentleTime += timeStep;
        m_gentleGrasp->setDisplacement(displacementAt(*m_gentlePull, m_gentleTime));
        m_gentleGrasp->advance(timeStep, acting.prescribed);
    }
    letGoOfLedNodes(acting.prescribed, led);
    try {
        return m_simulation->step(acting);
    } catch (const InvalidModel&) {
        // A shorter step can often be computed.
        return false;
    }
}

bool PreviewRun::goBack() {
    if (m_halvings < mostHalvings) {
        ++m_halvings;
        m_simulation->goBack(m_simulation->timeStep() / 2);
        // What the program's own steps do not calm was wild already when it was kept.
        if (isReplaced()) m_simulation->reset();
    } else if (!isReplaced() && m_settings.integrator != Integrator::Auto) {
        m_simulation->goBack(m_simulation->timeStep());
        replaceStepping(Replaced::RanWild);
    } else
        return false;
    // What is held takes hold anew, of the tissue where it is now.
    m_pull.reset();
    m_gentleGrasp.reset();
    m_debt = 0;
    return true;
}

void PreviewRun::replaceStepping(Replaced why) {
    m_replaced = why;
    m_halvings = 0;
    m_simulation->setModel(*m_model, {});
}

void PreviewRun::keepWithin(double safeStep) {
    // What is predicted for any deformation is on the safe side, and a step may be chosen close to it.
    constexpr double far = 2;
    if (!isReady() || isReplaced() || m_settings.integrator == Integrator::Auto) return;
    if (m_simulation->timeStep() > far * safeStep) replaceStepping(Replaced::BeyondSafe);
}

/// N·s, of the tissue on the instrument that is held, since the start.
Eigen::Vector3d PreviewRun::toldImpulse() const {
    const auto& touches = m_simulation->instrumentTouches();
    const std::size_t place = m_playsScene ? m_scene.instruments.size() : 0; // after those of the scene
    return place < touches.size() ? touches[place].impulse : Eigen::Vector3d::Zero();
}

/// Where instrument and tissue part the force goes at once.
void PreviewRun::measureForces(const Eigen::Vector3d& impulse, double simulated) {
    if (simulated <= 0) return;
    if (impulse.isZero(0))
        m_instrumentForce.clear();
    else
        m_instrumentForce.add(impulse / simulated, simulated);
    if (!m_pull) return m_pullForce.clear();
    m_pullForce.add(
        forceOn(m_pull->nodes(), m_simulation->system(), m_settings.damping, m_simulation->motion()),
        simulated);
}

std::optional<FeltTissue> PreviewRun::feltPull() const {
    const std::optional<double> force = m_pullForce.size();
    if (!m_pull || !force) return std::nullopt;
    const std::uint32_t node = m_pull->node();
    return FeltTissue{*force, (positions()[node] - m_network->restPositions[node]).norm()};
}

std::optional<FeltTissue> PreviewRun::feltInstrument() const {
    const std::optional<double> force = m_instrumentForce.size();
    if (!m_heldInstrument || !force) return std::nullopt;
    return FeltTissue{*force, displacementAt(*m_heldInstrument, m_network->restPositions, positions())};
}

std::vector<PartNow> PreviewRun::fluidsNow() const {
    const std::vector<SpringSystem::Filled>& cavities = m_simulation->system().cavities;
    std::vector<PartNow> parts;
    if (cavities.empty()) return parts;
    const std::vector<double> volumes = volumesOf(m_simulation->system(), positions());
    const Loads loads = sceneLoads();
    for (std::size_t i = 0; i < cavities.size(); ++i)
        parts.push_back({cavities[i].part, volumes[i], volumes[i] / cavities[i].restVolume,
                         ownPressure(cavities[i], volumes[i]) + pressureOfLoads(loads, cavities[i], 0)});
    return parts;
}

bool PreviewRun::advance(double seconds, const PreviewLoads& loads) {
    if (loads.pull && loads.pull->node >= m_network->restPositions.size()) return true;
    if (m_playsScene && isSceneOver()) leaveScene();
    followLoads(loads);
    const double timeStep = m_simulation->timeStep();
    // A slow machine does not run after lost time.
    m_debt = std::min(m_debt + seconds, 2 * seconds + timeStep);
    const auto start = Clock::now();
    const Eigen::Vector3d impulse = toldImpulse();
    double simulated = 0;
    while (m_debt >= timeStep && secondsSince(start) < seconds) {
        if (!step(loads)) {
            const std::string reason = m_simulation->failure();
            if (goBack()) return true;
            stop(reason);
            return false;
        }
        m_debt -= timeStep;
        simulated += timeStep;
        if (m_playsScene && isSceneOver()) {
            m_debt = 0;
            return false;
        }
    }
    measure(simulated, secondsSince(start));
    measureForces(toldImpulse() - impulse, simulated);
    return endTurn();
}

bool PreviewRun::follow(const Poke& poke, double until) {
    const Eigen::Vector3d impulse = toldImpulse();
    const double start = time();
    while (time() < until - m_simulation->timeStep() / 2) {
        const PreviewLoads loads = loadsAt(poke, time());
        followLoads(loads);
        if (step(loads)) continue;
        const std::string reason = m_simulation->failure();
        if (goBack()) continue;
        stop(reason);
        return false;
    }
    if (time() > start) measureForces(toldImpulse() - impulse, time() - start);
    return endTurn();
}

/// After some steps: whether the run can go on.
bool PreviewRun::endTurn() {
    if (!isDrawn()) {
        stop("the tissue moves too far away to be drawn: fix some of its nodes, tether it, or lower gravity");
        return false;
    }
    if (++m_framesSinceKept >= framesBetweenStates) {
        m_simulation->keepState();
        m_framesSinceKept = 0;
    }
    return true;
}

bool PreviewRun::isDrawn() const {
    return std::all_of(positions().begin(), positions().end(), isDrawable);
}

void PreviewRun::stop(const std::string& reason) {
    m_runFailure = reason;
    if (!m_simulation || isDrawn()) return;
    try {
        m_simulation->goBack(m_simulation->timeStep());
    } catch (const std::exception&) {
        m_simulation->reset();
    }
}

void PreviewRun::measure(double simulated, double computing) {
    constexpr double decay = 0.95;
    m_simulated = decay * m_simulated + simulated;
    m_computing = decay * m_computing + computing;
}

PreviewStatus PreviewRun::status() const {
    PreviewStatus status;
    if (m_simulation) {
        status.integrator = m_simulation->integrator();
        status.timeStep = m_simulation->timeStep();
        status.fluids = fluidsNow();
    }
    status.halvings = m_halvings;
    status.replaced = m_replaced;
    status.isShortened = m_isShortened && !isReplaced();
    status.realTimeFactor = m_computing > 0 ? m_simulated / m_computing : 0;
    status.pull = feltPull();
    status.instrument = feltInstrument();
    status.failure = m_modelFailure.empty() ? m_runFailure : m_modelFailure;
    return status;
}

} // namespace esm
