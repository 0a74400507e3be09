#include "tests/benchmarks/critical_step.h"

#include "core/dynamics/stability.h"
#include "core/dynamics/stability_memory.h"
#include "tests/benchmarks/slider.h"

namespace benchmarks {

namespace {

constexpr int searchRepetitions = 9;
constexpr double searchTolerance = 0.05; ///< as the editor's

template<class Search>
void registerSearch(const std::string& name, const Search& search, std::vector<Ratio>& ratios) {
    const std::string cold = name + ", anew", warm = name + ", from the last";
    registerWork(cold, searchRepetitions, [search] {
        return [slider = std::make_shared<Slider>(), search] { search(slider->move(), nullptr); };
    });
    registerWork(warm, searchRepetitions, [search] {
        const auto memory = std::make_shared<esm::StabilityMemory>();
        return
            [slider = std::make_shared<Slider>(), memory, search] { search(slider->move(), memory.get()); };
    });
    ratios.push_back({name + ", 10 k: from the last to anew", warm, cold, Clock::Thread});
}

} // namespace

std::vector<Ratio> registerCriticalStep() {
    std::vector<Ratio> ratios;
    registerSearch(
        "choosing the step",
        [](const esm::TissueModel& model, esm::StabilityMemory* memory) { chooseStep(model, {}, memory); },
        ratios);
    for (const esm::Integrator integrator :
         {esm::Integrator::Euler, esm::Integrator::Rk4, esm::Integrator::Split, esm::Integrator::Split2})
        registerSearch(
            "critical step of " + std::string(integratorName(integrator)),
            [integrator](const esm::TissueModel& model, esm::StabilityMemory* memory) {
                criticalStep(model, integrator, {searchTolerance, esm::Deformation::Any, {}, memory});
            },
            ratios);
    return ratios;
}

} // namespace benchmarks
