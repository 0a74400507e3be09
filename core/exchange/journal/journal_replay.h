#pragma once

#include "core/exchange/journal/journal_records.h"

namespace esm {

/// A step of the undo list, and what the project is after it.
struct ReplayedStep {
    std::string text;
    std::optional<RegionId> systemOf;
    StoredState state;
};

/// What a journal's records come to, without its blobs.
struct Replay {
    StoredState base; ///< before the first step
    std::vector<ReplayedStep> steps;
    std::size_t index = 0;            ///< steps that are done
    std::size_t taken = 0;            ///< records that made sense
    std::optional<std::size_t> clean; ///< as `index`, of what lies in the file
    JournalFile file;
    JournalView view;

    bool isUnsaved() const { return clean != index; }
    const StoredState& now() const { return at(index); }
    const StoredState& at(std::size_t place) const { return place == 0 ? base : steps[place - 1].state; }
};

/// Up to the first record that makes no sense after those before it; none where not even the first does.
/// @param mostSteps of the undo list; older ones leave it
std::optional<Replay> replay(const std::vector<nlohmann::ordered_json>& records, std::size_t count,
                             std::size_t mostSteps);

/// What the project is after each record that makes sense. Neighbours that are the same share their members.
std::vector<StoredState> statesAfter(const std::vector<nlohmann::ordered_json>& records,
                                     std::size_t mostSteps);

} // namespace esm
