#include "core/dynamics/schemes/step_scheme.h"

#include "core/dynamics/schemes/explicit_scheme.h"
#include "core/dynamics/schemes/matrix_scheme.h"
#include "core/dynamics/schemes/propagation.h"

namespace esm {

void StepScheme::steps(const SpringSystem& system, const StepInput& input, std::size_t count, Motion& motion,
                       StepperSolvers& solvers) {
    for (std::size_t i = 0; i < count; ++i) {
        Motion next = step(system, input, motion, solvers).motion;
        std::swap(motion, next);
        remember(std::move(next));
    }
}

std::unique_ptr<StepScheme> makeStepScheme(const SpringSystem& system, Integrator integrator,
                                           const SimulationSettings& settings, ThreadTeam* team) {
    if (traitsOf(integrator).kind == StepKind::Searching)
        return std::make_unique<PropagationScheme>(system, settings.damping, settings.isWanted);
    if (!isExplicit(integrator)) return std::make_unique<MatrixScheme>(integrator, settings.damping);
    const KernelOptions options{settings.damping, {}, team};
    if (settings.precision == Precision::Float)
        return std::make_unique<ExplicitScheme<float>>(system, integrator, options, settings.restTolerance);
    return std::make_unique<ExplicitScheme<double>>(system, integrator, options, settings.restTolerance);
}

} // namespace esm
