#pragma once

#include "core/exchange/simulators/handover.h"
#include "core/exchange/simulators/sofa/sofa_states.h"

#include <filesystem>
#include <optional>

namespace esm {

/// The installed `runSofa`: what the environment's ESM_RUNSOFA names, or else the first on the PATH. None
/// where that cannot be run.
std::optional<std::filesystem::path> installedSofa();

/// The release of an installed `runSofa`, by the name of the file that its links end at: `runSofa-26.06.00`.
/// None where that says none that scenes are written for.
std::optional<SofaVersion> releaseOfProgram(const std::filesystem::path& program);

/// How long SOFA runs, and how often it writes down where the nodes are.
struct SofaSchedule {
    double timeStep; ///< s
    std::size_t stepsPerRecord;
    std::size_t records; ///< after the start

    double every() const { return timeStep * static_cast<double>(stepsPerRecord); } ///< s
    double duration() const { return every() * static_cast<double>(records); }      ///< s
};

/// Some twenty records, all at ends of steps, as near to the duration as that allows.
/// @param duration s
/// @throws InvalidModel where that takes more steps than SOFA counts
SofaSchedule sofaSchedule(double duration, double timeStep);

/// How an organ moved in SOFA.
struct SofaRun {
    std::vector<SofaState> states;     ///< at the start and at every record, in order
    double wallPerSimulatedSecond = 0; ///< of stepping alone, as SOFA measures it
};

/// Hands an organ over, lets an installed SOFA step it without a window, and reads how it moved. SOFA ends
/// with this call, whatever becomes of that, and where the system has `setpriv` with the thread that called.
/// @param means with the schedule's step
/// @throws FileError where the program is of another release, which would move the organ otherwise without a
/// word; saying what SOFA said where it does not start, ends with an error, writes no motion or
/// not all of it, as on a full disk, or what readSofaStates() refuses; InvalidModel as writeSofa(); Cancelled
SofaRun runInSofa(const std::filesystem::path& program, const Handover& handover, const HandoverMeans& means,
                  const SofaSchedule& schedule);

} // namespace esm
