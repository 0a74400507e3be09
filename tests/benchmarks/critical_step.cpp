#include "tests/benchmarks/critical_step.h"

#include "core/dynamics/stability.h"
#include "core/dynamics/stability_memory.h"
#include "tests/support/tissue_models.h"

namespace benchmarks {

namespace {

constexpr int searchRepetitions = 9;
constexpr double searchTolerance = 0.05; ///< as the editor's

/// Tissue of 10 242 nodes, published parameters, half of it stiffer; the slider goes up and down.
class Slider {
public:
    Slider() {
        for (esm::TissueModel& model : m_models)
            model = tissue::fromMesh(tissue::sphereMesh(5, 0.05), {16.26, 2.877, 1e-4});
        for (std::size_t i = 0; i < m_models[0].mass.size(); ++i)
            for (const std::size_t place : {0U, 1U}) {
                m_models[place].springConstant[i] *= (i % 1000 < 500 ? 5 : 1) * (place == 0 ? 1 : 1.1);
                m_models[place].viscosity[i] *= i % 700 < 300 ? 0.2 : 1;
            }
    }
    const esm::TissueModel& move() { return m_models[m_moves++ % 2]; }

private:
    esm::TissueModel m_models[2];
    std::size_t m_moves = 0;
};

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
