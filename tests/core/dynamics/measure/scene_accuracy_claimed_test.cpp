#include "core/dynamics/measure/scene_accuracy.h"
#include "core/dynamics/stability/stability.h"
#include "core/support/errors.h"
#include "tests/support/reference_motion.h"
#include "tests/support/rounds.h"
#include "tests/support/sanitized.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

#include <ostream>
#include <random>

// What --max-error claims, held against a witness: random tissue under random scenes, run the way the
// command line does.

namespace esm {
namespace {

constexpr double mostUnderstated = 1.2; ///< true error over the claimed one

/// Draws numbers, the same on every machine.
class Dice {
public:
    explicit Dice(unsigned seed) : m_engine(seed) {}

    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(m_engine() >> 11) * 0x1p-53;
    }
    /// Each order of magnitude is as likely as the others.
    double magnitude(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(m_engine() % count); }
    bool chance(double share) { return between(0, 1) < share; }
    Eigen::Vector3d direction() {
        Eigen::Vector3d v;
        do
            v = {between(-1, 1), between(-1, 1), between(-1, 1)};
        while (v.norm() > 1 || v.norm() < 0.1);
        return v.normalized();
    }

private:
    std::mt19937_64 m_engine;
};

/// A run to a wanted error.
struct Trial {
    std::string tissue;
    TissueModel model;
    double size = 0;      ///< m, of a spring
    double frequency = 0; ///< rad/s, of its fastest swing
    Scene scene;
    SimulationSettings settings;
    double wanted = 0;
};

SpringNetwork tetrahedron(double size) {
    SpringNetwork network;
    network.restPositions = {
        {0, 0, 0}, {size, 0, 0}, {size / 2, 0.87 * size, 0}, {size / 2, 0.29 * size, 0.82 * size}};
    for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = 0; b < a; ++b)
            tissue::addSpring(network, b, a);
    return network;
}

SpringNetwork tube(std::size_t rings, std::size_t around, double size) {
    SpringNetwork network;
    for (std::size_t ring = 0; ring < rings; ++ring)
        for (std::size_t i = 0; i < around; ++i) {
            const double angle =
                2 * 3.14159265358979323846 * static_cast<double>(i) / static_cast<double>(around);
            network.restPositions.emplace_back(size * static_cast<double>(ring), size * std::cos(angle),
                                               size * std::sin(angle));
        }
    for (std::size_t ring = 0; ring < rings; ++ring)
        for (std::size_t i = 0; i < around; ++i) {
            tissue::addSpring(network, ring * around + i, ring * around + (i + 1) % around);
            if (ring + 1 < rings) tissue::addSpring(network, ring * around + i, (ring + 1) * around + i);
        }
    return network;
}

SpringNetwork drawnNetwork(Dice& dice, Trial& trial) {
    switch (dice.below(4)) {
    case 0:
        trial.tissue = "tetrahedron";
        return tetrahedron(trial.size);
    case 1: {
        trial.tissue = "membrane";
        const int perSide = 2 + static_cast<int>(dice.below(4));
        return networkFromMesh(tissue::gridMesh(perSide, trial.size * (perSide - 1)));
    }
    case 2:
        trial.tissue = "tube";
        return tube(2 + dice.below(4), 3 + dice.below(5), trial.size);
    default: {
        trial.tissue = "tethered node";
        SpringNetwork network;
        network.restPositions = {{0, 0, 0}};
        return network;
    }
    }
}

/// Light to heavy damping; every node has the same parameters, but for a part that is stiffer.
void drawTissue(Dice& dice, Trial& trial) {
    trial.size = dice.magnitude(0.005, 0.05);
    const double constant = dice.magnitude(10, 2000), mass = dice.magnitude(1e-4, 3e-3);
    const double damping = dice.chance(0.3) ? dice.magnitude(0.5, 20) : dice.magnitude(1e-3, 0.5);
    const double viscosity = 2 * damping * std::sqrt(constant * mass);
    trial.model = tissue::model(drawnNetwork(dice, trial), {constant, viscosity, mass});
    const std::size_t nodes = trial.model.mass.size();
    if (dice.chance(0.3))
        for (std::size_t i = 0; i < nodes / 2; ++i)
            trial.model.springConstant[i] *= 3;
    if (nodes == 1 || dice.chance(0.4))
        for (std::uint32_t i = 0; i < nodes; i += 3)
            trial.model.tethers.push_back({i, 0.3 * constant, 0.3 * viscosity});
    if (nodes > 1 && dice.chance(0.5)) trial.model.fixedNodes = {0};
    if (nodes > 1 && dice.chance(0.3))
        trial.model.stiffening = SpringStiffening{dice.between(0.02, 0.2), dice.magnitude(0.3, 8)};
    trial.frequency = largestAngularFrequency(trial.model);
}

/// A force, or a short blow that gives as much way.
NodeForce drawnForce(Dice& dice, const Trial& trial) {
    const double duration = trial.scene.duration, begins = dice.between(0, 0.7 * duration);
    const bool isShort = dice.chance(0.5);
    const double swing = 1 / trial.frequency;
    const double lasts = isShort ? dice.magnitude(0.003, 0.3) * swing : dice.between(0.1, 1) * duration;
    const double strength = dice.between(0.05, 0.3) * trial.size * trial.model.springConstant.back();
    const double force = isShort ? strength * std::min(30.0, swing / lasts) : strength;
    NodeForce drawn{static_cast<std::uint32_t>(dice.below(trial.model.mass.size())), force * dice.direction(),
                    begins, begins + lasts};
    if (dice.chance(0.2)) drawn.from = 0;
    return drawn;
}

/// As a hand moves it and a device records it: points at irregular times.
NodeMove drawnMove(Dice& dice, const Trial& trial) {
    const double duration = trial.scene.duration;
    NodeMove move{static_cast<std::uint32_t>(trial.model.mass.size() - 1), {}};
    const std::size_t points = dice.chance(0.5) ? 2 + dice.below(3) : 10 + dice.below(50);
    const double step = 0.4 * trial.size / std::sqrt(static_cast<double>(points));
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    double time = dice.chance(0.5) ? 0 : dice.between(0, 0.3) * duration;
    for (std::size_t i = 0; i < points; ++i) {
        move.path.push_back({time, place});
        time += dice.between(0.1, 1.9) * duration / static_cast<double>(points);
        place += step * dice.direction();
    }
    return move;
}

void drawScene(Dice& dice, Trial& trial) {
    Scene& scene = trial.scene;
    scene.duration = dice.magnitude(5, 150) / trial.frequency;
    scene.record.every = scene.duration / static_cast<double>(1 + dice.below(40));
    if (dice.chance(0.2)) scene.gravity = 0.05 * trial.size * std::pow(trial.frequency, 2) * dice.direction();
    const bool isLed = trial.model.mass.size() > 1 && dice.chance(0.4);
    if (isLed) scene.moves = {drawnMove(dice, trial)};
    for (std::size_t count = dice.below(3) + (isLed ? 0 : 1); count > 0; --count)
        scene.forces.push_back(drawnForce(dice, trial));
    if (!isLed && scene.forces.empty() && scene.gravity.isZero())
        scene.forces.push_back(drawnForce(dice, trial));
}

void drawSettings(Dice& dice, Trial& trial) {
    SimulationSettings& settings = trial.settings;
    if (dice.chance(0.25)) settings.damping = Damping::Axial;
    do
        settings.integrator =
            dice.chance(0.2) ? Integrator::Auto : allIntegrators[dice.below(allIntegrators.size())];
    while (settings.damping == Damping::Axial && hasConstantMatrix(settings.integrator));
    const double every = trial.scene.record.every;
    if (dice.chance(0.5))
        settings.timeStep = every / std::ceil(dice.magnitude(0.3, 3) * every * trial.frequency);
    constexpr double least[] = {0, 0.003, 1e-4, 0, 1e-6};
    trial.wanted = dice.magnitude(least[orderOf(settings.integrator)], 0.05);
}

Trial drawnTrial(unsigned seed) {
    Dice dice(seed);
    Trial trial;
    drawTissue(dice, trial);
    drawScene(dice, trial);
    drawSettings(dice, trial);
    return trial;
}

std::ostream& operator<<(std::ostream& out, const Trial& trial) {
    const auto& [tissue, model, size, frequency, scene, settings, wanted] = trial;
    out << integratorName(settings.integrator) << (settings.damping == Damping::Axial ? " axial" : "") << ", "
        << tissue << " of " << model.mass.size() << (model.stiffening ? " biphasic" : "") << ", damping "
        << model.viscosity[0] * frequency / 2 / model.springConstant[0] << ", step "
        << (settings.timeStep ? *settings.timeStep * frequency : 0) << " and frames "
        << scene.record.every * frequency << " of " << scene.duration * frequency << ", wanted " << wanted;
    for (const NodeForce& force : scene.forces)
        out << ", force for " << (force.to - force.from) * frequency;
    for (const NodeMove& move : scene.moves)
        out << ", path of " << move.path.size();
    return out;
}

/// What came of a trial.
struct Verdict {
    enum class Kind { Claimed, Refused, SaysItHides } kind;
    double claimed = 0, error = 0, witness = 0; ///< relative to the motion; `witness` is the witness's own
    SceneOutcome outcome = {};
    std::string refusal = {};
};

Verdict judge(const Trial& trial) {
    std::vector<double> times;
    std::vector<reference::Vectors> frames;
    const auto newSink = [&]() -> FrameSink {
        times.clear();
        frames.clear();
        return [&](double time, const std::vector<Eigen::Vector3d>& positions) {
            times.push_back(time);
            frames.push_back(positions);
        };
    };
    Verdict verdict{Verdict::Kind::Claimed};
    try {
        const AccurateOutcome accurate =
            runSceneToError({trial.model, {}, trial.scene, trial.settings}, trial.wanted, newSink);
        verdict.claimed = accurate.estimatedError;
        verdict.outcome = accurate.outcome;
        if (accurate.hidesSwings) verdict.kind = Verdict::Kind::SaysItHides;
    } catch (const InvalidModel& refused) {
        verdict.kind = Verdict::Kind::Refused;
        verdict.refusal = refused.what();
        return verdict;
    }
    const auto exact = reference::exactMotion({trial.model, trial.scene, trial.settings.damping}, times);
    verdict.error = reference::relativeDifference(frames, exact.places, trial.model.network->restPositions);
    verdict.witness = exact.error;
    return verdict;
}

bool isUnderstated(const Verdict& verdict) {
    return verdict.kind == Verdict::Kind::Claimed &&
           verdict.error > mostUnderstated * verdict.claimed + verdict.witness;
}

std::ostream& operator<<(std::ostream& out, const Verdict& verdict) {
    if (verdict.kind == Verdict::Kind::Refused) return out << "refused: " << verdict.refusal;
    return out << "claimed " << verdict.claimed << ", true " << verdict.error << " ("
               << verdict.error / verdict.claimed << " x, witness " << verdict.witness << ") by "
               << integratorName(verdict.outcome.integrator) << " in " << verdict.outcome.steps
               << " steps of " << verdict.outcome.timeStep << " s"
               << (verdict.kind == Verdict::Kind::SaysItHides ? ", and said that it hides swings" : "");
}

TEST(ClaimedError, IsNoLessThanTheTrueOne) {
    const int rounds = roundsOf(isSanitized() ? 1 : 6, 200);
    int claims = 0;
    for (int round = 0; round < rounds; ++round) {
        const Trial trial = drawnTrial(seedOf(round));
        const Verdict verdict = judge(trial);
        claims += verdict.kind == Verdict::Kind::Claimed;
        EXPECT_FALSE(isUnderstated(verdict)) << "seed " << seedOf(round) << ": " << trial << "\n" << verdict;
    }
    EXPECT_GT(claims, rounds / 2); // not refused, or said to hide swings
}

} // namespace
} // namespace esm
