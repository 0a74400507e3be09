#pragma once

#include "core/dynamics/prepared_model.h"
#include "core/model/gentle_pull.h"
#include "core/project/project.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace esm {

/// s; of longer steps the organ would be seen to jump.
inline constexpr double longestWatchedStep = 0.04;

/// A project made ready to be watched.
struct PreparedProject {
    Project project;
    std::shared_ptr<const TissueModel> tissue; ///< what it is made of; null where it cannot be evaluated
    /// Stepped as the project says, in steps that can be watched; none where it cannot be simulated.
    std::optional<PreparedModel> model;
    std::optional<GentlePull> gentlePull;
    std::string failure; ///< why there is no model; empty when all is well
};

using TissueEvaluated = std::function<void(const std::shared_ptr<const TissueModel>& tissue)>;

/// Takes up to a tenth of a second for ten thousand nodes, on any thread.
/// @param evaluated hears of the tissue, or that there is none, before its matrices are factorised
/// @param factoriser kept by those who prepare one project after the other: most have the same network
PreparedProject prepareProject(const Project& project, const TissueEvaluated& evaluated = {},
                               const std::shared_ptr<MatrixFactoriser>& factoriser = nullptr);

} // namespace esm
