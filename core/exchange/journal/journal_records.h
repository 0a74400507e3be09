#pragma once

#include "core/exchange/journal/journal_facts.h"
#include "core/project/project.h"
#include "core/support/progress.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The records of a recovery journal: a line each, every one a step on from what those before it say.
namespace esm {

/// A project's manifest member by member, the names of its entries' blobs, and the identities that its
/// manifest leaves out. Members that stay as they were are shared.
using StoredState = std::map<std::string, std::shared_ptr<const nlohmann::ordered_json>>;

/// The blobs of each entry of a manifest, in order.
using EntryBlobs = std::map<std::string, std::vector<std::string>>;

StoredState storedState(const Project& project, const nlohmann::ordered_json& manifest,
                        const EntryBlobs& blobs);

/// The manifest alone. @throws InvalidModel where the rest is no such thing
nlohmann::ordered_json manifestOf(const StoredState& state);
EntryBlobs blobsOf(const StoredState& state); ///< @throws InvalidModel

/// Gives the parts of a project that was read their identities. @throws InvalidModel where they do not fit
void giveIdentities(Project& project, const StoredState& state);

/// What of a state is not as it was: new members, and the names of those that are gone.
nlohmann::ordered_json changeOf(const StoredState& before, const StoredState& after);

// Each record as JSON.
/// @param place of the state: those before it are left out
nlohmann::ordered_json openRecord(const StoredState& state, std::uint64_t place = 0);
/// @param before the state of the record with a state that was written last
nlohmann::ordered_json editRecord(const JournalStep& step, const StoredState& before,
                                  const StoredState& after);
/// @param last the last step that can be redone
nlohmann::ordered_json moveRecord(std::uint64_t place, std::uint64_t last);
nlohmann::ordered_json fileRecord(const JournalFile& file);
nlohmann::ordered_json viewRecord(const JournalView& view);

/// A record as a line of the journal: its check sum, then JSON. @throws InvalidModel where it could not be
/// read again
std::string recordLine(const nlohmann::ordered_json& record);

/// The records of a journal up to the first one that is damaged. None of it can be trusted.
struct JournalRecords {
    std::vector<nlohmann::ordered_json> records;
    bool areWhole = true; ///< else there is more, that cannot be read; a torn last line is no damage
};
JournalRecords recordsIn(std::string_view text, const Progress& progress = {}); ///< @throws Cancelled

} // namespace esm
