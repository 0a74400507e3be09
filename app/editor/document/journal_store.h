#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/journal_habits.h"
#include "core/exchange/journal/journal_records.h"
#include "core/exchange/project/project_content.h"
#include "core/support/appended_file.h"

#include <QLockFile>

namespace esm {

/// The folder of a journal while it is written: `records`, and in `blobs` arrays, strokes and pictures, each
/// a file that is named by its hash. For one thread.
class JournalStore {
public:
    JournalStore(std::filesystem::path folder, const JournalBounds& bounds)
        : m_folder(std::move(folder)), m_bounds(bounds) {}

    /// Writes all of it anew and only then lets go of what was there. Places begin at 0 again.
    /// @throws FileError, InvalidModel for a project that could not be read again; nothing can be added then
    /// until it succeeds
    void begin(const DocumentState& state, const JournalView& view);
    /// On the disk with sync(), as the other records. Throws as begin().
    void addEdit(const JournalStep& step, const Project& after);
    void addMove(std::uint64_t place, std::uint64_t last);
    void add(const nlohmann::ordered_json& record);
    void sync();
    /// Whether it is to begin anew; it may keep nothing until then.
    bool hasOutgrown() const;
    /// After an error. What was written may be gone, as with a disk that is taken away.
    void giveUp();
    /// Removes the folder, where there is one.
    void end();

private:
    struct Content;
    StoredState stateOf(const Project& project, Content* used = nullptr);
    std::string blobOf(const ContentPiece& piece);
    std::string stored(const Bytes& blob);
    std::string stepsText(const DocumentState& state, std::uint64_t most, Content& used);
    void removeUnused(const Content& used);
    void takeLock();

    std::filesystem::path m_folder;
    JournalBounds m_bounds;
    std::unique_ptr<QLockFile> m_lock; ///< says that the program runs
    std::unique_ptr<AppendedFile> m_records;
    StoredState m_written;     ///< by the last record with a state
    std::uint64_t m_first = 0; ///< place of the first state that was written
    bool m_isBehind = false;   ///< the document went back to a step that was left out
    /// Blobs of what lives still, by its place in memory and its entry: written once, and hashed once.
    struct Known {
        std::weak_ptr<const void> source;
        std::string blob;
    };
    std::map<std::pair<const void*, std::string>, Known> m_known;
    bool m_hasNewBlobs = false;
    std::uint64_t m_wholeRecords = 0, m_addedRecords = 0, m_wholeBlobs = 0, m_addedBlobs = 0; ///< bytes
};

/// A file's version as a journal tells it; empty where it is not known.
std::vector<std::int64_t> numbersOf(const std::optional<FileVersion>& version);

/// The document's file as a journal tells it.
JournalFile journalFile(const DocumentFile& file);

/// The lock beside a journal, or beside a copy that an earlier version left. It is stale, and can be taken,
/// once its program does not run any more.
std::unique_ptr<QLockFile> lockBeside(const std::filesystem::path& place);

std::string hashOf(const Bytes& bytes); ///< SHA-256 in hexadecimal digits

} // namespace esm
