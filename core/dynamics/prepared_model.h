#pragma once

#include "core/dynamics/schemes/step_solvers.h"
#include "core/dynamics/settings.h"

namespace esm {

/// A tissue and how to step it, with all done that takes long: the step is chosen, and its matrices are
/// factorised. It can be made on any thread while a simulation goes on by the parameters it has, so that old
/// parameters and old matrices serve together until this takes their place.
struct PreparedModel {
    SpringSystem system;
    SimulationSettings settings;
    ChosenStep chosen;
    StepSolvers solvers; ///< of the fixed nodes
};

/// @param factoriser one that no other thread uses meanwhile; null: one of its own
/// @throws InvalidModel with every problem of model or settings
PreparedModel prepareModel(const TissueModel& model, const SimulationSettings& settings,
                           std::shared_ptr<MatrixFactoriser> factoriser = nullptr);

/// The same where the step is chosen. @throws InvalidModel when its matrices cannot be factorised
PreparedModel prepareModel(SpringSystem system, const SimulationSettings& settings, const ChosenStep& chosen,
                           std::shared_ptr<MatrixFactoriser> factoriser = nullptr);

} // namespace esm
