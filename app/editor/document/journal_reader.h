#pragma once

#include "app/editor/document/left_behind.h"
#include "core/exchange/journal/journal_replay.h"

namespace esm {

std::filesystem::path recordsOf(const std::filesystem::path& journal);

/// What the records of a journal come to; none where not even the first can be read.
/// @throws Cancelled
std::optional<Replay> replayOf(const std::filesystem::path& journal, const Progress& progress = {});

/// See bringBack().
BroughtBack readJournal(const std::filesystem::path& journal, const Progress& progress);

/// The organ's name in a state that cannot be trusted; empty where it has none.
QString organNameIn(const StoredState& state);

} // namespace esm
