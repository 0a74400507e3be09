#include "tests/benchmarks/stiff_tissue.h"

#include "core/dynamics/stability/stability.h"
#include "core/project/project.h"
#include "core/samples/samples.h"
#include "tests/benchmarks/accuracy.h"
#include "tests/benchmarks/naive_tissue.h"

#include <cstdio>

namespace benchmarks {

namespace {

constexpr int stiffRepetitions = 5;
constexpr double naivePart = 0.02; ///< of the time that the others simulate: each step costs the same

using MakeTissue = std::function<PulledTissue()>;

std::uint32_t firstFreeNode(const esm::TissueModel& model) {
    std::uint32_t node = 0;
    while (std::binary_search(model.fixedNodes.begin(), model.fixedNodes.end(), node))
        ++node;
    return node;
}

PulledTissue published(const std::string& sample) {
    esm::TissueModel model = evaluateModel(esm::makeSample(sample));
    const std::uint32_t node = firstFreeNode(model);
    return {std::move(model), node, {0.02, 0, 0.05}, 1};
}

std::function<void()> naiveRun(const PulledTissue& tissue) {
    const double step = *criticalStep(tissue.model, esm::Integrator::Euler);
    const auto naive = std::make_shared<NaiveTissue>(makeSpringSystem(tissue.model));
    const auto steps = static_cast<std::size_t>(naivePart * tissue.seconds / step);
    return [naive, step, steps] {
        for (std::size_t i = 0; i < steps; ++i)
            naive->step(step);
    };
}

/// With as few steps as the error allows.
std::function<void()> accurateRun(const PulledTissue& tissue, esm::Integrator integrator, double mostError,
                                  const esm::Trajectory& reference) {
    const int steps = fewestSteps(tissue, integrator, mostError, reference);
    std::printf("%s takes steps of %.3g s\n", std::string(integratorName(integrator)).c_str(),
                tissue.seconds / steps);
    esm::SimulationSettings settings;
    settings.integrator = integrator;
    settings.timeStep = tissue.seconds / steps;
    const auto simulation = std::make_shared<esm::Simulation>(tissue.model, settings);
    esm::Loads loads;
    loads.forces = {{tissue.node, tissue.force}};
    return [simulation, loads, steps] {
        simulation->reset();
        simulation->advance(loads, static_cast<std::size_t>(steps));
    };
}

struct Subject {
    std::string name;
    MakeTissue make;
    esm::Integrator integrator;
    double mostError;
    esm::Integrator referenceIntegrator;
    int referenceSteps;
    double aim;
};

void registerSubject(const Subject& subject, std::vector<Ratio>& ratios) {
    const std::string naive = subject.name + ", naive, a part of the time",
                      fast = subject.name + ", " + std::string(integratorName(subject.integrator));
    registerWork(naive, stiffRepetitions, [subject] { return naiveRun(subject.make()); });
    registerWork(fast, stiffRepetitions, [subject] {
        const PulledTissue tissue = subject.make();
        return accurateRun(tissue, subject.integrator, subject.mostError,
                           trajectoryOf(tissue, subject.referenceIntegrator, subject.referenceSteps));
    });
    ratios.push_back(
        {fast + " faster than naive by", naive, fast, Clock::Thread, subject.aim, 0, 1 / naivePart});
}

} // namespace

std::vector<Ratio> registerStiffTissue() {
    using esm::Integrator;
    std::vector<Ratio> ratios;
    for (const char* const organ : {"tube", "ventricle"})
        registerSubject({organ, [organ] { return published(organ); }, Integrator::Split2, 0.01,
                         Integrator::Split2, frameCount << 9, 1000},
                        ratios);
    const std::pair<std::string, Eigen::Vector3d> forces[] = {{"along", {0.05, 0.02, 0}},
                                                              {"across", {0.02, 0.01, 0.05}}};
    for (const auto& [direction, force] : forces)
        registerSubject({"membrane, damping 5ω, pulled " + direction,
                         [force = force] { return pulledMembrane(20000, 5, force, 1); }, Integrator::Implicit,
                         0.1, Integrator::Bdf2, frameCount << 9, 15},
                        ratios);
    return ratios;
}

} // namespace benchmarks
