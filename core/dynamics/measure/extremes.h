#pragma once

#include "core/dynamics/settings.h"
#include "core/model/tissue_model.h"
#include "core/support/progress.h"

namespace esm {

/// A small tissue at the edge of what sliders and files can ask for, and what pulls at it.
struct ExtremeCase {
    std::string family, name;
    TissueModel model;
    std::uint32_t pulledNode;
    Eigen::Vector3d force;          ///< N, for the first half of the run
    std::optional<double> timeStep; ///< s; chosen safely without
};

/// Spring constants from 10⁻⁶ to 10⁹ N/m, viscosities from 0 to 10⁶ N·s/m and masses from 10⁻⁹ to 10³ kg in
/// all combinations, with chosen steps; given steps from 10⁻⁷ to 1 s with soft, stiff and viscous tissue;
/// tissue of odd shapes; and biphasic springs.
std::vector<ExtremeCase> extremeCases();

enum class ExtremeEnd {
    Ran,     ///< to its end, every number finite, and without energy that nothing gave
    Stopped, ///< with the reason and the last good state
    Refused  ///< before it began, or a step of it, with the reason
};

struct ExtremeOutcome {
    ExtremeEnd end;
    std::string reason; ///< empty when it ran
};

/// Runs a case for so many steps.
ExtremeOutcome runExtreme(const ExtremeCase& tested, Integrator integrator, int steps = 200);

/// What a family of cases came to under one integrator.
struct ExtremeSummary {
    std::string family;
    Integrator integrator;
    int ran = 0, stopped = 0, refused = 0;
    std::string reason; ///< the first there was
};

/// Every case under `Auto` and every integrator, in the order of families and integrators. @throws Cancelled
std::vector<ExtremeSummary> sweepExtremes(const Progress& progress = {});

} // namespace esm
