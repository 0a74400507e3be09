#include "tests/benchmarks/slider_move.h"

#include "core/dynamics/schemes/step_solver.h"
#include "core/dynamics/simulation.h"
#include "core/dynamics/stability/stability.h"
#include "tests/benchmarks/slider.h"

namespace benchmarks {

namespace {

constexpr int moveRepetitions = 9;

esm::SimulationSettings settingsOf(esm::Integrator integrator) {
    esm::SimulationSettings settings;
    settings.integrator = integrator;
    settings.threads = 1;
    if (integrator != esm::Integrator::Auto) settings.timeStep = 1e-4;
    return settings;
}

/// Of both forms, on what was analysed before.
std::function<void()> factorisations(esm::Integrator integrator) {
    const auto system = std::make_shared<esm::SpringSystem>(makeSpringSystem(Slider().move()));
    const auto factoriser = std::make_shared<esm::MatrixFactoriser>();
    return [system, factoriser, integrator] {
        for (const bool builds : {false, true})
            factoriser->factorise(
                laplacianMatrix(*system, esm::stepFactors(integrator, 1e-4, builds), system->fixed),
                system->network->restPositions);
    };
}

void registerMove(esm::Integrator integrator, std::vector<Ratio>& ratios) {
    const std::string name = integratorName(integrator);
    const std::string move = "slider's move, " + name, anew = "simulation made anew, " + name,
                      step = "a step after it, " + name, factors = "factorisations, " + name;
    registerWork(move, moveRepetitions, [integrator] {
        const auto slider = std::make_shared<Slider>();
        const auto simulation = std::make_shared<esm::Simulation>(slider->move(), settingsOf(integrator));
        return [slider, simulation] { simulation->setModel(slider->move()); };
    });
    registerWork(anew, moveRepetitions, [integrator] {
        return [slider = std::make_shared<Slider>(), integrator] {
            esm::Simulation(slider->move(), settingsOf(integrator));
        };
    });
    registerWork(step, moveRepetitions, [integrator] {
        const auto simulation = std::make_shared<esm::Simulation>(Slider().move(), settingsOf(integrator));
        return [simulation] { simulation->step({}); };
    });
    ratios.push_back({"slider's move, 10 k, " + name + ": to anew", move, anew, Clock::Thread});
    ratios.push_back({"slider's move, 10 k, " + name + ": to a step", move, step, Clock::Thread});
    if (!hasSecondOrderForm(integrator)) return;
    registerWork(factors, moveRepetitions, [integrator] { return factorisations(integrator); });
    ratios.push_back({"slider's move, 10 k, " + name + ": to factorisations", move, factors, Clock::Thread});
}

} // namespace

std::vector<Ratio> registerSliderMove() {
    std::vector<Ratio> ratios;
    for (const esm::Integrator integrator :
         {esm::Integrator::Auto, esm::Integrator::Split2, esm::Integrator::Bdf2, esm::Integrator::Euler})
        registerMove(integrator, ratios);
    return ratios;
}

} // namespace benchmarks
