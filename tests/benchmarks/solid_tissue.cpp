#include "tests/benchmarks/solid_tissue.h"

#include "core/dynamics/contact/node_impulses.h"
#include "core/dynamics/simulation.h"
#include "core/solid/filled_body.h"
#include "tests/support/solid_surfaces.h"
#include "tests/support/tissue_models.h"

#include <algorithm>
#include <numeric>

namespace benchmarks {

namespace {

constexpr int solidRepetitions = 5;
constexpr double solidStep = 0.01; ///< s
constexpr tissue::Parameters solidParameters{16.26, 2.877, 1e-4};

esm::TissueModel latticeOf(double spacing) {
    const esm::TriangleMesh ball = esm::test::ball(0.05, Eigen::Vector3d::Zero());
    const esm::FilledBody body = esm::fillBody(ball, {esm::LatticeKind::BodyCentred, spacing});
    esm::SpringNetwork network;
    network.restPositions = body.nodes;
    for (const esm::LatticeSpring& spring : body.springs)
        tissue::addSpring(network, spring.first, spring.second);
    return tissue::model(std::move(network), solidParameters);
}

esm::TissueModel netOf(int rings) {
    return tissue::fromMesh(esm::test::ball(0.05, Eigen::Vector3d::Zero(), rings), solidParameters);
}

esm::SimulationSettings solidSettings() {
    esm::SimulationSettings settings;
    settings.integrator = esm::Integrator::Split2;
    settings.timeStep = solidStep;
    settings.threads = 1;
    return settings;
}

using MakeModel = std::function<esm::TissueModel()>;

void registerSetUp(const std::string& name, const MakeModel& makeModel) {
    registerWork("set-up, " + name, solidRepetitions, [makeModel] {
        return [model = std::make_shared<esm::TissueModel>(makeModel())] {
            esm::Simulation(*model, solidSettings());
        };
    });
}

void registerSteps(const std::string& name, const MakeModel& makeModel) {
    registerWork("step, " + name, solidRepetitions, [makeModel] {
        const auto simulation = std::make_shared<esm::Simulation>(makeModel(), solidSettings());
        return [simulation] { simulation->step({}); };
    });
}

/// Up and down on the same network.
void registerSolidMove(const std::string& name, const MakeModel& makeModel) {
    registerWork("slider's move, " + name, solidRepetitions, [makeModel] {
        auto firmer = makeModel(), softer = firmer;
        for (double& springConstant : firmer.springConstant)
            springConstant *= 1.1;
        const auto simulation = std::make_shared<esm::Simulation>(softer, solidSettings());
        return [firmer, softer, simulation, up = false]() mutable {
            simulation->setModel((up = !up) ? firmer : softer);
        };
    });
}

/// A hundred nodes that nothing has touched before.
void registerTouch(const std::string& name, const MakeModel& makeModel) {
    registerWork("first touch, " + name, solidRepetitions, [makeModel] {
        const esm::SpringSystem system = makeSpringSystem(makeModel());
        esm::MatrixFactoriser factoriser;
        const auto matrix = std::make_shared<esm::StepMatrix>(system, esm::MatrixFactors{1, solidStep, 0},
                                                              system.fixed, factoriser);
        std::vector<std::uint32_t> nodes(system.mass.size());
        std::iota(nodes.begin(), nodes.end(), 0U);
        const auto height = [&](std::uint32_t node) { return system.network->restPositions[node].z(); };
        std::sort(nodes.begin(), nodes.end(), [&](auto a, auto b) { return height(a) > height(b); });
        nodes.resize(100);
        return [matrix, nodes] { benchmark::DoNotOptimize(esm::NodeImpulses(*matrix).response(nodes)); };
    });
}

void registerSize(const std::string& size, const MakeModel& lattice, const MakeModel& net,
                  std::vector<Ratio>& ratios) {
    const std::string solid = "solid of " + size, surface = "net of " + size;
    for (const auto& [name, model] : {std::pair(solid, lattice), std::pair(surface, net)}) {
        registerSetUp(name, model);
        registerSteps(name, model);
    }
    registerSolidMove(solid, lattice);
    registerTouch(solid, lattice);
    const auto toNet = [&](const std::string& work, double aim) {
        ratios.push_back({work + ", solid to net, " + size, work + ", " + solid, work + ", " + surface,
                          Clock::Thread, 0, aim});
    };
    toNet("set-up", 0);
    toNet("step", 8);
    for (const std::string work : {"slider's move, ", "first touch, ", "set-up, "})
        ratios.push_back(
            {work + "solid of " + size + ": to a step", work + solid, "step, " + solid, Clock::Thread});
}

} // namespace

std::vector<Ratio> registerSolidTissue() {
    std::vector<Ratio> ratios;
    registerSize(
        "10 k", [] { return latticeOf(0.0041); }, [] { return netOf(71); }, ratios);
    registerSize(
        "50 k", [] { return latticeOf(0.0024); }, [] { return netOf(158); }, ratios);
    return ratios;
}

} // namespace benchmarks
