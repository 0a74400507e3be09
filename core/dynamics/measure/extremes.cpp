#include "core/dynamics/measure/extremes.h"

#include "core/dynamics/measure/watched_run.h"
#include "core/geometry/triangle_mesh.h"
#include "core/support/errors.h"
#include "core/support/joined.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Eigen::Vector3d;

constexpr int perSide = 6;

/// A sheet of 0.1 m with the diagonals of its squares, held along one side. Small, since every case is run by
/// every integrator, some 1200 runs in all.
SpringNetwork sheet() {
    SpringNetwork network;
    for (int y = 0; y < perSide; ++y)
        for (int x = 0; x < perSide; ++x)
            network.restPositions.emplace_back(0.02 * x, 0.02 * y, 0);
    const auto join = [&network](int first, int second) {
        const auto a = static_cast<std::uint32_t>(first), b = static_cast<std::uint32_t>(second);
        network.springs.push_back({a, b, (network.restPositions[a] - network.restPositions[b]).norm()});
    };
    for (int y = 0; y < perSide; ++y)
        for (int x = 0; x < perSide; ++x) {
            const int node = y * perSide + x;
            if (x + 1 < perSide) join(node, node + 1);
            if (y + 1 < perSide) join(node, node + perSide);
            if (x + 1 < perSide && y + 1 < perSide) join(node, node + perSide + 1);
        }
    return network;
}

struct Parameters {
    double springConstant = 10, viscosity = 0.1, mass = 0.001; ///< N/m, N·s/m, kg per node
};

TissueModel tissueOf(SpringNetwork network, const Parameters& parameters) {
    TissueModel model;
    const std::size_t count = network.restPositions.size();
    model.network = std::make_shared<const SpringNetwork>(std::move(network));
    model.springConstant.assign(count, parameters.springConstant);
    model.viscosity.assign(count, parameters.viscosity);
    model.mass.assign(count, parameters.mass);
    for (std::uint32_t node = 0; node < perSide; ++node)
        model.fixedNodes.push_back(node);
    return model;
}

/// Pulled at the last node: a corner across from the held side, or what the case has added.
ExtremeCase pulled(std::string family, std::string name, TissueModel model) {
    const auto last = static_cast<std::uint32_t>(model.mass.size() - 1);
    // What the softest spring stretches by a millimetre.
    const double force = 0.001 * *std::min_element(model.springConstant.begin(), model.springConstant.end());
    return {std::move(family), std::move(name), std::move(model), last, {0, 0, force}, {}};
}

// From far below to far above any tissue, in all combinations: what one extreme does not break, two of them
// together may, as a stiff spring on a light node does.
void addParameters(std::vector<ExtremeCase>& cases) {
    for (const double springConstant : {1e-6, 1.0, 1e4, 1e9})
        for (const double viscosity : {0.0, 1e-6, 1.0, 1e3, 1e6})
            for (const double mass : {1e-9, 1e-3, 1e3}) {
                const std::string name = roundedText(springConstant) + " N/m, " + roundedText(viscosity) +
                                         " N·s/m, " + roundedText(mass) + " kg";
                cases.push_back(pulled("spring constant, viscosity and mass", name,
                                       tissueOf(sheet(), {springConstant, viscosity, mass})));
            }
}

/// Soft, stiff and viscous tissue in steps that somebody typed in. Too long ones must be told, not computed
/// on.
void addSteps(std::vector<ExtremeCase>& cases) {
    for (const double step : {1e-7, 1e-5, 1e-3, 1e-1, 1.0})
        for (const Parameters& parameters :
             {Parameters{}, Parameters{1e4, 1e-3, 1e-3}, Parameters{10, 1e3, 1e-3}}) {
            ExtremeCase given =
                pulled("a given step", roundedText(step) + " s", tissueOf(sheet(), parameters));
            given.timeStep = step;
            cases.push_back(std::move(given));
        }
}

// Shapes that meet a division by zero somewhere, if it has no guard: lengths, areas and matrices that vanish.
void addShapes(std::vector<ExtremeCase>& cases) {
    SpringNetwork flat = sheet();
    flat.restPositions[20] = flat.restPositions[21];
    for (Spring& spring : flat.springs)
        spring.restLength = (flat.restPositions[spring.first] - flat.restPositions[spring.second]).norm();
    cases.push_back(pulled("a spring of no length", "two nodes in one place", tissueOf(flat, {})));

    SpringNetwork needles = sheet();
    for (Vector3d& position : needles.restPositions)
        position.x() *= 1e-6;
    for (Spring& spring : needles.springs)
        spring.restLength =
            (needles.restPositions[spring.first] - needles.restPositions[spring.second]).norm();
    cases.push_back(pulled("needle triangles", "a millionth as wide as long", tissueOf(needles, {})));

    SpringNetwork loose = sheet();
    loose.restPositions.emplace_back(1, 1, 1);
    cases.push_back(pulled("a free node", "no spring holds it", tissueOf(loose, {})));

    TissueModel fixed = tissueOf(sheet(), {});
    fixed.fixedNodes.clear();
    for (std::uint32_t node = 0; node < fixed.mass.size(); ++node)
        fixed.fixedNodes.push_back(node);
    cases.push_back(pulled("all nodes fixed", "nothing can move", std::move(fixed)));

    for (const double contrast : {1e-6, 1e6}) {
        TissueModel model = tissueOf(sheet(), {});
        for (std::size_t node = model.mass.size() / 2; node < model.mass.size(); ++node) {
            model.springConstant[node] *= contrast;
            model.viscosity[node] *= contrast;
        }
        cases.push_back(pulled("neighbours of 10⁶-fold contrast", roundedText(contrast), std::move(model)));
    }

    ExtremeCase stretched = pulled("forces that stretch tissue tenfold", "", tissueOf(sheet(), {}));
    stretched.force = {0, 10, 0};
    cases.push_back(std::move(stretched));
}

/// Springs that become softer or stiffer at once, in use, or never. Where their law changes its slope jumps.
void addSecondPhases(std::vector<ExtremeCase>& cases) {
    for (const double strain : {1e-9, 0.2, 1e3})
        for (const double factor : {1e-9, 1e-3, 1e3, 1e9}) {
            TissueModel model = tissueOf(sheet(), {});
            model.stiffening = SpringStiffening{strain, factor};
            ExtremeCase stretched =
                pulled("springs of another stiffness when stretched",
                       roundedText(factor) + " times beyond " + roundedText(strain), std::move(model));
            if (factor > 1) stretched.force = {0, 10, 0};
            cases.push_back(std::move(stretched));
        }
}

void requireFinite(const Simulation& simulation) {
    const auto isFinite = [](const Vector3d& vector) { return vector.allFinite(); };
    if (!std::all_of(simulation.positions().begin(), simulation.positions().end(), isFinite) ||
        !std::all_of(simulation.velocities().begin(), simulation.velocities().end(), isFinite))
        throw std::logic_error("an extreme run kept a state that is not finite");
}

/// Takes a step. Why it is not good; empty when it is.
std::string problemOfStep(Simulation& simulation, WatchedRun& watched, const Loads& loads, bool isLast) {
    watched.begin();
    const bool good = simulation.step(loads);
    requireFinite(simulation);
    return good ? watched.problemAfter(loads, simulation.timeStep(), 1, isLast) : simulation.failure();
}

} // namespace

std::vector<ExtremeCase> extremeCases() {
    std::vector<ExtremeCase> cases;
    addParameters(cases);
    addSteps(cases);
    addShapes(cases);
    addSecondPhases(cases);
    return cases;
}

// Half of the run under load, half without: energy out of nothing shows in the swings that a load leaves, and
// in creeping back. To stop with a reason is no failure. A state that is not finite is one, whatever the
// reason says.
ExtremeOutcome runExtreme(const ExtremeCase& tested, Integrator integrator, int steps) {
    SimulationSettings settings;
    settings.integrator = integrator;
    settings.timeStep = tested.timeStep;
    try {
        Simulation simulation(tested.model, settings);
        settings.integrator = simulation.integrator();
        WatchedRun watched(simulation, settings);
        Loads loads;
        loads.forces = {{tested.pulledNode, tested.force}};
        for (int step = 1; step <= steps; ++step) {
            if (step > steps / 2) loads = {};
            const std::string problem = problemOfStep(simulation, watched, loads, step == steps);
            if (!problem.empty()) return {ExtremeEnd::Stopped, problem};
        }
        return {ExtremeEnd::Ran, {}};
    } catch (const InvalidModel& reason) {
        return {ExtremeEnd::Refused, joined(reason.problems(), "; ")};
    }
}

std::vector<ExtremeSummary> sweepExtremes(const Progress& progress) {
    std::vector<Integrator> integrators{Integrator::Auto};
    integrators.insert(integrators.end(), allIntegrators.begin(), allIntegrators.end());
    const std::vector<ExtremeCase> cases = extremeCases();
    std::vector<ExtremeSummary> summaries;
    const auto summaryOf = [&summaries](const std::string& family, Integrator integrator) -> ExtremeSummary& {
        const auto found =
            std::find_if(summaries.begin(), summaries.end(), [&](const ExtremeSummary& summary) {
                return summary.family == family && summary.integrator == integrator;
            });
        if (found != summaries.end()) return *found;
        return summaries.emplace_back(ExtremeSummary{family, integrator, 0, 0, 0, {}});
    };
    for (std::size_t i = 0; i < cases.size(); ++i)
        for (const Integrator integrator : integrators) {
            reportProgress(progress, static_cast<double>(i) / static_cast<double>(cases.size()));
            const ExtremeOutcome outcome = runExtreme(cases[i], integrator);
            ExtremeSummary& summary = summaryOf(cases[i].family, integrator);
            ++(outcome.end == ExtremeEnd::Ran       ? summary.ran
               : outcome.end == ExtremeEnd::Stopped ? summary.stopped
                                                    : summary.refused);
            if (summary.reason.empty()) summary.reason = outcome.reason;
        }
    return summaries;
}

} // namespace esm
