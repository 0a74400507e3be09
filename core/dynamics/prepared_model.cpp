#include "core/dynamics/prepared_model.h"

#include "core/dynamics/stability/stability.h"

#include <utility>

namespace esm {

PreparedModel prepareModel(const TissueModel& model, const SimulationSettings& settings,
                           std::shared_ptr<MatrixFactoriser> factoriser) {
    SpringSystem system = makeSpringSystem(model);
    const ChosenStep chosen = chooseStep(system, settings);
    return prepareModel(std::move(system), settings, chosen, std::move(factoriser));
}

// Integrators of the second order take their first step by a form of the first, which has a matrix of its
// own.
PreparedModel prepareModel(SpringSystem system, const SimulationSettings& settings, const ChosenStep& chosen,
                           std::shared_ptr<MatrixFactoriser> factoriser) {
    if (!factoriser) factoriser = std::make_shared<MatrixFactoriser>();
    StepSolvers solvers(system.fixed, std::move(factoriser));
    const auto [integrator, timeStep] = chosen;
    if (traitsOf(integrator).kind == StepKind::Solving) solvers.linear(system, integrator, timeStep, false);
    if (hasSecondOrderForm(integrator)) solvers.linear(system, integrator, timeStep, true);
    return {std::move(system), settings, chosen, std::move(solvers)};
}

} // namespace esm
