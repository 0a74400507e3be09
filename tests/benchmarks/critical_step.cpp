#include "tests/benchmarks/critical_step.h"

#include "core/dynamics/schemes/step_solver.h"
#include "core/dynamics/stability/stability.h"
#include "tests/benchmarks/slider.h"

namespace benchmarks {

namespace {

constexpr int searchRepetitions = 9;
constexpr double searchTolerance = 0.05; ///< as the editor's
const std::string reference = "factorising a step's matrix";

template<class Work> void registerAfterMove(const std::string& name, Work work) {
    registerWork(name, searchRepetitions,
                 [work] { return [slider = std::make_shared<Slider>(), work] { work(slider->move()); }; });
}

template<class Search>
void registerSearch(const std::string& name, const Search& search, std::vector<Ratio>& ratios) {
    registerAfterMove(name, search);
    ratios.push_back({name + ", 10 k: to a factorisation", name, reference, Clock::Thread});
}

void factorise(const esm::TissueModel& model) {
    const esm::SpringSystem system = makeSpringSystem(model);
    esm::MatrixFactoriser factoriser;
    const esm::StepMatrix matrix(system, stepFactors(esm::Integrator::Split, 0.01, false), system.fixed,
                                 factoriser);
}

} // namespace

std::vector<Ratio> registerCriticalStep() {
    std::vector<Ratio> ratios;
    registerAfterMove(reference, factorise);
    registerSearch(
        "choosing the step", [](const esm::TissueModel& model) { chooseStep(model, {}); }, ratios);
    for (const esm::Integrator integrator :
         {esm::Integrator::Euler, esm::Integrator::Rk4, esm::Integrator::Split, esm::Integrator::Split2})
        registerSearch(
            "critical step of " + std::string(integratorName(integrator)),
            [integrator](const esm::TissueModel& model) {
                criticalStep(model, integrator, {searchTolerance, esm::Deformation::Any, {}});
            },
            ratios);
    return ratios;
}

} // namespace benchmarks
