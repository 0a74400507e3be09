#include "tests/support/reference_motion.h"

#include <algorithm>
#include <cmath>

namespace reference {

namespace {

using esm::Damping;
using esm::NodeForce;
using esm::NodeMove;
using esm::Path;
using Columns = Eigen::Matrix3Xd; ///< one per node

struct State {
    Columns places, velocities; ///< m, m/s; or their changes with time
};

/// A stretch of time in which no force begins or ends and no path turns.
struct Segment {
    double from, to; ///< s
};

Eigen::Vector3d placeOn(const Path& path, double time) {
    if (time <= path.front().time) return path.front().value;
    for (std::size_t i = 1; i < path.size(); ++i)
        if (time <= path[i].time) {
            const double share = (time - path[i - 1].time) / (path[i].time - path[i - 1].time);
            return (1 - share) * path[i - 1].value + share * path[i].value;
        }
    return path.back().value;
}

/// m/s, within a segment.
Eigen::Vector3d velocityOn(const Path& path, const Segment& segment) {
    const double middle = (segment.from + segment.to) / 2;
    for (std::size_t i = 1; i < path.size(); ++i)
        if (path[i - 1].time < middle && middle < path[i].time)
            return (path[i].value - path[i - 1].value) / (path[i].time - path[i - 1].time);
    return Eigen::Vector3d::Zero();
}

/// What pulls two nodes together, N, with R 2.21 and, beyond the strain, the line of the other constant that
/// goes on from there.
double tensionOf(double length, double restLength, double constant,
                 const std::optional<esm::SpringStiffening>& law) {
    const double linear = constant * (length - restLength);
    if (!law) return linear;
    const double atStrain = (1 + law->strain) * restLength;
    if (length <= atStrain) return linear;
    return constant * law->strain * restLength + law->factor * constant * (length - atStrain);
}

class Tissue {
public:
    explicit Tissue(const Experiment& experiment)
        : m_experiment(experiment), m_isFree(experiment.model.mass.size(), true) {
        for (const std::uint32_t node : experiment.model.fixedNodes)
            m_isFree[node] = false;
        for (const NodeMove& move : experiment.scene.moves)
            m_isFree[move.node] = false;
    }

    State atRest() const {
        const Vectors& rest = m_experiment.model.network->restPositions;
        State state{Columns(3, rest.size()), Columns::Zero(3, static_cast<Eigen::Index>(rest.size()))};
        for (std::size_t i = 0; i < rest.size(); ++i)
            state.places.col(static_cast<Eigen::Index>(i)) = rest[i];
        return state;
    }

    /// From here on until the segment ends, nothing that acts changes but with the motion.
    void enter(const Segment& segment, State& state) {
        const auto& [model, scene, damping] = m_experiment;
        m_external = Columns::Zero(3, state.places.cols());
        for (std::size_t i = 0; i < model.mass.size(); ++i)
            m_external.col(static_cast<Eigen::Index>(i)) = model.mass[i] * scene.gravity;
        const double middle = (segment.from + segment.to) / 2;
        for (const NodeForce& force : scene.forces)
            if (force.from <= middle && middle < force.to) m_external.col(force.node) += force.force;
        for (const NodeMove& move : scene.moves) {
            const Eigen::Vector3d& rest = model.network->restPositions[move.node];
            state.places.col(move.node) = rest + placeOn(move.path, segment.from);
            state.velocities.col(move.node) = velocityOn(move.path, segment);
        }
    }

    State change(const State& state) const {
        Columns forces = m_external;
        addSprings(state, forces);
        addTethers(state, forces);
        for (std::size_t i = 0; i < m_isFree.size(); ++i) {
            auto force = forces.col(static_cast<Eigen::Index>(i));
            force *= m_isFree[i] ? 1 / m_experiment.model.mass[i] : 0;
        }
        return {state.velocities, forces};
    }

private:
    void addSprings(const State& state, Columns& forces) const {
        const esm::TissueModel& model = m_experiment.model;
        for (const esm::Spring& spring : model.network->springs) {
            const auto [a, b, restLength] = spring;
            const double constant = (model.springConstant[a] + model.springConstant[b]) / 2;
            const double viscosity = (model.viscosity[a] + model.viscosity[b]) / 2;
            const Eigen::Vector3d between = state.places.col(b) - state.places.col(a);
            const Eigen::Vector3d parting = state.velocities.col(b) - state.velocities.col(a);
            const double length = between.norm();
            const Eigen::Vector3d along = length > 0 ? Eigen::Vector3d(between / length) : between;
            Eigen::Vector3d pull = viscosity * parting;
            if (m_experiment.damping == Damping::Axial) pull = viscosity * along.dot(parting) * along;
            pull += tensionOf(length, restLength, constant, model.stiffening) * along;
            forces.col(a) += pull;
            forces.col(b) -= pull;
        }
    }

    void addTethers(const State& state, Columns& forces) const {
        const esm::TissueModel& model = m_experiment.model;
        for (const esm::Tether& tether : model.tethers) {
            const Eigen::Vector3d& rest = model.network->restPositions[tether.node];
            forces.col(tether.node) += tether.springConstant * (rest - state.places.col(tether.node)) -
                                       tether.viscosity * state.velocities.col(tether.node);
        }
    }

    Experiment m_experiment;
    std::vector<bool> m_isFree;
    Columns m_external; ///< N
};

/// Weights of the changes found so far, the newest last, in the state where the next one is asked; those of
/// the last row make the step itself.
constexpr double stageWeights[6][6] = {
    {1.0 / 5},
    {3.0 / 40, 9.0 / 40},
    {44.0 / 45, -56.0 / 15, 32.0 / 9},
    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
    {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};

/// The step's own weights less those of the fourth order.
constexpr double errorWeights[7] = {71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
                                    -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

/// state + h·Σ weight·change
State moved(const State& state, double h, const std::vector<State>& changes, const double* weights) {
    State result = state;
    for (std::size_t i = 0; i < changes.size(); ++i) {
        if (weights[i] == 0) continue;
        result.places += h * weights[i] * changes[i].places;
        result.velocities += h * weights[i] * changes[i].velocities;
    }
    return result;
}

class Integration {
public:
    Integration(const Experiment& experiment, double tolerance)
        : m_tissue(experiment), m_state(m_tissue.atRest()), m_duration(experiment.scene.duration),
          m_tolerance(tolerance), m_step(1e-3 * experiment.scene.duration) {}

    void follow(const Segment& segment) {
        m_tissue.enter(segment, m_state);
        std::vector<State> changes{m_tissue.change(m_state)};
        for (double time = segment.from; time < segment.to;) {
            const bool reachesEnd = time + 1.01 * m_step >= segment.to;
            const double h = reachesEnd ? segment.to - time : m_step;
            const double error = tryStep(h, changes);
            const double change = std::clamp(0.9 * std::pow(error, -0.2), 0.2, 5.0);
            if (error > 1) {
                m_step = change * h;
                changes.resize(1);
                continue;
            }
            // A step that a corner cut short says nothing of how long the next may be.
            m_step = reachesEnd ? std::max(m_step, change * h) : change * h;
            m_state = std::move(m_next);
            changes = {std::move(changes.back())};
            time = reachesEnd ? segment.to : time + h;
        }
    }

    Vectors places() const {
        Vectors result;
        for (Eigen::Index node = 0; node < m_state.places.cols(); ++node)
            result.emplace_back(m_state.places.col(node));
        return result;
    }

private:
    /// What the step would be off over what it may be; the last of the changes is then that of its end.
    double tryStep(double h, std::vector<State>& changes) {
        for (const auto& weights : stageWeights) {
            m_next = moved(m_state, h, changes, weights);
            changes.push_back(m_tissue.change(m_next));
        }
        const State none{Columns::Zero(3, m_state.places.cols()), Columns::Zero(3, m_state.places.cols())};
        const State off = moved(none, h, changes, errorWeights);
        // A velocity that is off leads astray for the rest of the time at most.
        const double farthest = std::max(off.places.colwise().norm().maxCoeff(),
                                         m_duration * off.velocities.colwise().norm().maxCoeff());
        return std::max(farthest / m_tolerance, 1e-10);
    }

    Tissue m_tissue;
    State m_state, m_next;
    double m_duration, m_tolerance, m_step;
};

/// Times at which a force begins or ends or a path turns, s.
std::vector<double> cornersOf(const esm::Scene& scene) {
    std::vector<double> corners;
    for (const NodeForce& force : scene.forces)
        corners.insert(corners.end(), {force.from, force.to});
    for (const NodeMove& move : scene.moves)
        for (const esm::PathPoint& point : move.path)
            corners.push_back(point.time);
    return corners;
}

/// m, from rest, of the farthest node.
double farthestWay(const std::vector<Vectors>& motion, const Vectors& rest) {
    double farthest = 0;
    for (const Vectors& places : motion)
        for (std::size_t i = 0; i < rest.size(); ++i)
            farthest = std::max(farthest, (places[i] - rest[i]).norm());
    return farthest;
}

} // namespace

std::vector<Vectors> placesAt(const Experiment& experiment, const std::vector<double>& times,
                              double tolerance) {
    std::vector<double> stops = cornersOf(experiment.scene);
    stops.insert(stops.end(), times.begin(), times.end());
    std::sort(stops.begin(), stops.end());
    Integration integration(experiment, tolerance);
    std::vector<Vectors> result;
    double now = 0;
    auto stop = stops.begin();
    for (const double wanted : times) {
        for (; stop != stops.end() && *stop <= wanted; ++stop) {
            if (*stop <= now) continue;
            integration.follow({now, *stop});
            now = *stop;
        }
        result.push_back(integration.places());
    }
    return result;
}

ExactMotion exactMotion(const Experiment& experiment, const std::vector<double>& times) {
    // Of the motion; a hundredth of it is near what rounding leaves of places and forces.
    constexpr double rough = 1e-4, fine = 1e-9;
    const Vectors& rest = experiment.model.network->restPositions;
    const double size = (rest.front() - rest.back()).norm() + 1e-3;
    const double way = farthestWay(placesAt(experiment, times, rough * size), rest);
    if (!(way > 0)) return {placesAt(experiment, times, fine * size), 0};
    const auto checked = placesAt(experiment, times, fine * way);
    ExactMotion motion{placesAt(experiment, times, 0.03 * fine * way)};
    motion.error = relativeDifference(checked, motion.places, rest);
    return motion;
}

double relativeDifference(const std::vector<Vectors>& motion, const std::vector<Vectors>& exact,
                          const Vectors& rest) {
    double apart = 0, way = 0;
    for (std::size_t time = 0; time < exact.size(); ++time)
        for (std::size_t i = 0; i < rest.size(); ++i) {
            apart += (motion[time][i] - exact[time][i]).squaredNorm();
            way += (exact[time][i] - rest[i]).squaredNorm();
        }
    return std::sqrt(apart / way);
}

} // namespace reference
