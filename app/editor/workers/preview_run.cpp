#include "app/editor/workers/preview_run.h"

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

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

SimulationSettings settingsOf(const Project& project) {
    if (!project.stepping) return {};
    Stepping stepping = project.stepping->stepping;
    stepping.timeStep /= std::max(1.0, std::ceil(stepping.timeStep / longestWatchedStep));
    return withStepping({}, stepping);
}

} // namespace

bool PreviewRun::setProject(const Project& project) {
    try {
        const bool goesOn = m_simulation && m_model.network == project.network;
        TissueModel model = evaluateModel(project);
        const SimulationSettings settings = settingsOf(project);
        if (goesOn)
            m_simulation->setModel(model, settings);
        else
            m_simulation.emplace(model, settings, touchedSurface(*project.mesh, *project.network));
        m_model = std::move(model);
        m_settings = settings;
        m_isShortened = project.stepping && *settings.timeStep < project.stepping->stepping.timeStep;
        m_gravity = project.scene.gravity;
        if (!goesOn) {
            m_pull.reset();
            m_gentleGrasp.reset();
            m_gentleTime = 0;
        }
        m_gentlePull = gentlePull(m_model);
        m_halvings = 0;
        m_isReplaced = false;
        m_modelFailure.clear();
        m_runFailure.clear();
        return true;
    } catch (const std::exception& error) {
        m_modelFailure = error.what();
        if (!m_simulation) m_model.network = project.network;
        return false;
    }
}

void PreviewRun::reset() {
    m_pull.reset();
    m_gentleGrasp.reset();
    m_gentleTime = 0;
    m_debt = 0;
    m_runFailure.clear();
    if (!m_simulation) return;
    if (m_halvings > 0 || m_isReplaced) m_simulation->setModel(m_model, m_settings);
    m_halvings = 0;
    m_isReplaced = false;
    m_simulation->reset();
}

const std::vector<Eigen::Vector3d>& PreviewRun::positions() const {
    static const std::vector<Eigen::Vector3d> none;
    if (m_simulation) return m_simulation->positions();
    return m_model.network ? m_model.network->restPositions : none;
}

void PreviewRun::followLoads(const PreviewLoads& loads) {
    if (!loads.pull)
        m_pull.reset();
    else if (!m_pull || m_pull->node() != loads.pull->node)
        m_pull.emplace(m_model, m_simulation->positions(), loads.pull->node);
    if (m_pull) m_pull->setTarget(loads.pull->target);

    if (!loads.gentleMotion || !m_gentlePull)
        m_gentleGrasp.reset();
    else if (!m_gentleGrasp)
        m_gentleGrasp.emplace(m_model, m_simulation->positions(), m_gentlePull->node);
}

bool PreviewRun::step(const PreviewLoads& loads) {
    const double timeStep = m_simulation->timeStep();
    Loads acting;
    acting.gravity = m_gravity;
    if (loads.instrument) acting.instruments = {*loads.instrument};
    if (m_pull) m_pull->advance(timeStep, acting.held);
    if (m_gentleGrasp) {
        m_gentleTime += timeStep;
        m_gentleGrasp->setDisplacement(displacementAt(*m_gentlePull, m_gentleTime));
        m_gentleGrasp->advance(timeStep, acting.held);
    }
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
        if (m_isReplaced) m_simulation->reset();
    } else if (!m_isReplaced && m_settings.integrator != Integrator::Auto) {
        m_isReplaced = true;
        m_halvings = 0;
        m_simulation->goBack(m_simulation->timeStep());
        m_simulation->setModel(m_model, {});
    } else
        return false;
    // What is held takes hold anew, of the tissue where it is now.
    m_pull.reset();
    m_gentleGrasp.reset();
    m_debt = 0;
    return true;
}

bool PreviewRun::advance(double seconds, const PreviewLoads& loads) {
    if (loads.pull && loads.pull->node >= m_model.network->restPositions.size()) return true;
    followLoads(loads);
    const double timeStep = m_simulation->timeStep();
    // A slow machine does not run after lost time.
    m_debt = std::min(m_debt + seconds, 2 * seconds + timeStep);
    const auto start = Clock::now();
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
    }
    measure(simulated, secondsSince(start));
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
    }
    status.halvings = m_halvings;
    status.isReplaced = m_isReplaced;
    status.isShortened = m_isShortened && !m_isReplaced;
    status.realTimeFactor = m_computing > 0 ? m_simulated / m_computing : 0;
    status.failure = m_modelFailure.empty() ? m_runFailure : m_modelFailure;
    return status;
}

} // namespace esm
