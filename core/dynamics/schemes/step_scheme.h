#pragma once

#include "core/dynamics/schemes/stepper_solvers.h"
#include "core/dynamics/settings.h"

#include <memory>

namespace esm {

class ThreadTeam;

/// Steps tissue that nothing touches, with what it carries from step to step: by a kernel of accelerations,
/// node by node, or by solving.
class StepScheme {
public:
    StepScheme() = default;
    StepScheme& operator=(const StepScheme&) = delete;
    virtual ~StepScheme() = default;

    /// One step. Led nodes are up to rounding where they are led.
    /// @throws InvalidModel when no solution is found, Cancelled
    virtual UntouchedStep step(const SpringSystem& system, const StepInput& input, const Motion& before,
                               StepperSolvers& solvers) = 0;

    /// So many steps one after the other, which lead nothing.
    virtual void steps(const SpringSystem& system, const StepInput& input, std::size_t count, Motion& motion,
                       StepperSolvers& solvers);

    /// The next step may build on the one that started here. Precondition: it was the last to be computed.
    virtual void remember(Motion /*before*/) {}

    /// Forgets what earlier steps left behind, as when the motion was changed from outside.
    virtual void restart() {}

    /// Share of the nodes that the last steps were computed for.
    virtual double activeFraction() const { return 1; }

    /// The same for other parameters of the same network and hinges; null where nothing of it would be kept.
    virtual std::unique_ptr<StepScheme> withParameters(const SpringSystem& /*system*/) const {
        return nullptr;
    }

protected:
    StepScheme(const StepScheme&) = default;
};

/// @param team outlives the scheme; null is one thread
std::unique_ptr<StepScheme> makeStepScheme(const SpringSystem& system, Integrator integrator,
                                           const SimulationSettings& settings, ThreadTeam* team);

} // namespace esm
