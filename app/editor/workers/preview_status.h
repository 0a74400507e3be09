#pragma once

#include "app/editor/workers/felt_tissue.h"
#include "core/model/stepping.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace esm {

/// Why a run steps otherwise than its project says.
enum class Replaced {
    Not,
    RanWild,   ///< ever wilder, however short the steps
    BeyondSafe ///< its step is far beyond the longest stable one
};

/// What a part of the surface that holds a fluid, or is pressed from within, is like now.
struct PartNow {
    std::uint32_t part = 0; ///< as of a filling
    double volume = 0;      ///< m³
    double share = 1;       ///< of the volume at rest
    double pressure = 0;    ///< Pa, all that presses from within
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
    std::vector<PartNow> fluids; ///< of every part that holds one; none without a simulation
    std::string failure;         ///< why the tissue cannot move; empty when all is well
};

} // namespace esm
