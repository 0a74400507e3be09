#pragma once

#include "app/editor/workers/felt_tissue.h"
#include "core/model/stepping.h"

#include <optional>
#include <string>

namespace esm {

/// Why a run steps otherwise than its project says.
enum class Replaced {
    Not,
    RanWild,   ///< ever wilder, however short the steps
    BeyondSafe ///< its step is far beyond the longest stable one
};

/// How the run goes.
struct PreviewStatus {
    bool playing = false;
    std::optional<Integrator> integrator; ///< none without a simulation
    double timeStep = 0;                  ///< s
    std::optional<double> safeStep;    ///< s, largest stable step of the integrator; infinite without a limit
    double realTimeFactor = 0;         ///< simulated over computing time
    int halvings = 0;                  ///< of the step, each time that the motion ran wild
    Replaced replaced = Replaced::Not; ///< the project's way to step, by the program's
    bool isShortened = false;          ///< the project's step, which is too long to be watched
    /// Forces are means over a moment. None while nothing is pulled, or the instrument touches nothing.
    std::optional<FeltTissue> pull, instrument;
    std::string failure; ///< why the tissue cannot move; empty when all is well
};

} // namespace esm
