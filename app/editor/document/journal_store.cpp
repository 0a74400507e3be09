#include "app/editor/document/journal_store.h"

#include "core/support/atomic_file.h"
#include "core/support/errors.h"

#include <QCryptographicHash>

#include <algorithm>
#include <numeric>
#include <set>

namespace esm {

namespace fs = std::filesystem;

namespace {

void makeFolder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw FileError(folder, "cannot be made: " + error.message() + "; make room for a folder there");
}

fs::path lockFileOf(const fs::path& place) {
    return fs::path(place).replace_extension(".lock");
}

/// Place of the first state such that the steps after it take at most so many bytes, or are to be redone.
std::size_t firstKept(const std::vector<std::string>& steps, std::size_t index, std::uint64_t most) {
    std::uint64_t size = 0;
    std::size_t first = steps.size();
    while (first > 0 && (first > index || size + steps[first - 1].size() <= most))
        size += steps[--first].size();
    return first;
}

void requireReadable(const fs::path& journal, std::uint64_t records) {
    if (records > largestRecords)
        throw FileError(journal, "would be too large to be read again; save the project");
}

std::string textOf(const std::optional<fs::path>& path) {
    return path ? path->string() : std::string();
}

} // namespace

/// The blobs that states name.
struct JournalStore::Content {
    std::set<std::string> blobs;
};

std::vector<std::int64_t> numbersOf(const std::optional<FileVersion>& version) {
    if (!version) return {};
    return {static_cast<std::int64_t>(version->device), static_cast<std::int64_t>(version->inode),
            static_cast<std::int64_t>(version->size), version->modified};
}

JournalFile journalFile(const DocumentFile& file) {
    JournalFile told{textOf(file.path), file.former.title.toStdString(), textOf(file.former.path),
                     numbersOf(file.version), std::nullopt};
    if (file.clean >= 0) told.clean = static_cast<std::uint64_t>(file.clean);
    return told;
}

std::unique_ptr<QLockFile> lockBeside(const fs::path& place) {
    auto lock = std::make_unique<QLockFile>(QString::fromStdString(lockFileOf(place).string()));
    lock->setStaleLockTime(0);
    return lock;
}

std::string hashOf(const Bytes& bytes) {
    QCryptographicHash hash(QCryptographicHash::Sha256);
    // In parts, since Qt counts bytes as int.
    constexpr std::size_t part = 1 << 28;
    for (std::size_t done = 0; done < bytes.size(); done += part)
        hash.addData(reinterpret_cast<const char*>(bytes.data()) + done,
                     static_cast<int>(std::min(part, bytes.size() - done)));
    return hash.result().toHex().toStdString();
}

void JournalStore::takeLock() {
    // The folder may have gone with its lock, as with a disk that is taken away.
    std::error_code none;
    if (m_lock && m_lock->isLocked() && fs::exists(lockFileOf(m_folder), none)) return;
    m_lock = lockBeside(m_folder);
    if (!m_lock->tryLock())
        throw FileError(lockFileOf(m_folder),
                        "cannot be locked; make sure that files can be made in its folder");
}

std::string JournalStore::stored(const Bytes& blob) {
    std::string name = hashOf(blob);
    const fs::path file = m_folder / "blobs" / name;
    std::error_code none;
    if (fs::file_size(file, none) == blob.size()) return name;
    writeFileAtomically(file, blob);
    m_hasNewBlobs = true;
    m_addedBlobs += blob.size();
    return name;
}

std::string JournalStore::blobOf(const ContentPiece& piece) {
    Known& known = m_known[{piece.source.get(), piece.entry}];
    // Something else may lie where what was known is gone.
    if (known.source.lock() != piece.source) known = {piece.source, stored(piece.bytes())};
    return known.blob;
}

StoredState JournalStore::stateOf(const Project& project, Content* used) {
    const ProjectContent content = contentOf(project);
    const std::vector<std::string> problems = manifestProblems(project, content.manifest);
    if (!problems.empty()) throw InvalidModel(problems);
    EntryBlobs blobs;
    for (const ContentPiece& piece : content.pieces) {
        const std::string blob = blobOf(piece);
        blobs[piece.entry].push_back(blob);
        if (used) used->blobs.insert(blob);
    }
    return storedState(project, content.manifest, blobs);
}

/// From the state after as many steps as it takes to stay within `most`, with those that can be redone.
std::string JournalStore::stepsText(const DocumentState& state, std::uint64_t most, Content& used) {
    std::vector<StoredState> states{stateOf(*state.base, &used)};
    std::vector<std::string> edits;
    for (const DocumentStep& step : state.steps) {
        states.push_back(stateOf(*step.after, &used));
        const JournalStep told{edits.size() + 1, step.text.toStdString(), step.systemOf};
        edits.push_back(recordLine(editRecord(told, states[edits.size()], states.back())));
    }
    m_written = states.back();
    m_first = firstKept(edits, static_cast<std::size_t>(state.index), most);
    const auto kept = edits.begin() + static_cast<std::ptrdiff_t>(m_first);
    return std::accumulate(kept, edits.end(), recordLine(openRecord(states[m_first], m_first)));
}

void JournalStore::begin(const DocumentState& state, const JournalView& view) {
    m_records.reset();
    m_isBehind = false;
    makeFolder(m_folder.parent_path());
    takeLock();
    makeFolder(m_folder / "blobs");
    std::erase_if(m_known, [](const auto& known) { return known.second.source.expired(); });
    Content used;
    const std::string text =
        stepsText(state, m_bounds.mostRecords / 2, used) +
        recordLine(moveRecord(static_cast<std::uint64_t>(state.index), state.steps.size())) +
        recordLine(fileRecord(journalFile(state.file))) + recordLine(viewRecord(view));
    requireReadable(m_folder, text.size());
    syncFolder(m_folder / "blobs");
    writeFileAtomically(m_folder / "records", text);
    syncFolder(m_folder);
    syncFolder(m_folder.parent_path());
    m_records = std::make_unique<AppendedFile>(m_folder / "records");
    m_wholeRecords = text.size();
    m_addedRecords = 0;
    m_hasNewBlobs = false;
    removeUnused(used);
}

void JournalStore::removeUnused(const Content& used) {
    std::error_code none;
    m_wholeBlobs = 0;
    m_addedBlobs = 0;
    for (const auto& entry : fs::directory_iterator(m_folder / "blobs", none))
        if (used.blobs.contains(entry.path().filename().string()))
            m_wholeBlobs += entry.file_size(none);
        else
            fs::remove(entry.path(), none);
    std::erase_if(m_known, [&](const auto& known) { return !used.blobs.contains(known.second.blob); });
}

void JournalStore::addEdit(const JournalStep& step, const Project& after) {
    if (m_isBehind) return;
    StoredState state = stateOf(after);
    add(editRecord(step, m_written, state));
    m_written = std::move(state);
}

void JournalStore::addMove(std::uint64_t place, std::uint64_t last) {
    m_isBehind = m_isBehind || place < m_first;
    add(moveRecord(place, last));
}

void JournalStore::add(const nlohmann::ordered_json& record) {
    if (m_isBehind) return;
    const std::string line = recordLine(record);
    requireReadable(m_folder, m_wholeRecords + m_addedRecords + line.size());
    // No record may reach the disk before what it names.
    if (m_hasNewBlobs) syncFolder(m_folder / "blobs");
    m_hasNewBlobs = false;
    m_records->append(line);
    m_addedRecords += line.size();
}

void JournalStore::sync() {
    if (m_records) m_records->sync();
}

bool JournalStore::hasOutgrown() const {
    const std::uint64_t growth = std::min(2 * m_wholeRecords, m_bounds.mostRecords / 2);
    return m_isBehind || m_addedRecords > std::max(m_bounds.leastGrowth, growth) ||
           m_addedBlobs > std::max(m_bounds.leastGrowth, m_wholeBlobs);
}

void JournalStore::giveUp() {
    m_records.reset();
    m_known.clear();
}

void JournalStore::end() {
    std::error_code none;
    giveUp();
    // Without its records a journal is nothing, wherever this stops.
    fs::remove(m_folder / "records", none);
    fs::remove_all(m_folder, none);
    m_lock.reset();
}

} // namespace esm
