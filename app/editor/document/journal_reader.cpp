#include "app/editor/document/journal_reader.h"

#include "app/editor/document/journal_store.h"
#include "core/exchange/project/project_content.h"
#include "core/support/errors.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace esm {

namespace fs = std::filesystem;
using ProjectValue = std::shared_ptr<const Project>;

namespace {

JournalRecords readRecords(const fs::path& journal, const Progress& progress) {
    ProgressParts parts(progress);
    const fs::path file = recordsOf(journal);
    if (regularFileSize(file) > largestRecords)
        throw FileError(file, "is larger than a journal can be; discard it");
    const Bytes text = readFile(file, largestRecords, parts.next(0.2));
    return recordsIn({reinterpret_cast<const char*>(text.data()), text.size()}, parts.rest());
}

bool isHash(const std::string& name) {
    return name.size() == 64 && name.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// Reads states of a journal, the same parts once.
class StateReader {
public:
    explicit StateReader(const fs::path& journal) : m_blobs(journal / "blobs") {}

    /// @throws InvalidModel where it cannot be read, Cancelled
    ProjectValue read(const StoredState& state, const Progress& progress) {
        reportProgress(progress, 0);
        const EntryBlobs blobs = blobsOf(state);
        const ContentSource source{
            [&](const std::string& entry, std::uint64_t largest, const Progress& reading) {
                return joined(blobs, entry, largest, reading);
            },
            [&](const std::string& entry) { return names(blobs, entry); }};
        ReadContent content = projectFrom(manifestOf(state), source, m_shared, progress);
        if (!content.problems.empty()) throw InvalidModel(content.problems);
        giveIdentities(content.project, state);
        share(content.project);
        m_warnings = std::move(content.warnings);
        m_latest = std::make_shared<const Project>(std::move(content.project));
        return m_latest;
    }

    /// Of the state that was read last.
    const std::vector<std::string>& warnings() const { return m_warnings; }

private:
    static std::string names(const EntryBlobs& blobs, const std::string& entry) {
        const auto found = blobs.find(entry);
        if (found == blobs.end()) return {};
        return std::accumulate(found->second.begin(), found->second.end(), std::string());
    }

    Bytes joined(const EntryBlobs& blobs, const std::string& entry, std::uint64_t largest,
                 const Progress& progress) {
        const auto found = blobs.find(entry);
        if (found == blobs.end()) throw InvalidModel("the entry " + entry + " is missing");
        Bytes bytes;
        double read = 0;
        for (const std::string& name : found->second) {
            reportProgress(progress, read++ / static_cast<double>(found->second.size()));
            const Bytes blob = readOnce(name, largest - bytes.size());
            bytes.insert(bytes.end(), blob.begin(), blob.end());
        }
        return bytes;
    }

    /// One that is damaged is read once: a state names it in each step.
    Bytes readOnce(const std::string& name, std::uint64_t largest) {
        if (!isHash(name)) throw InvalidModel("a blob's name is no hash");
        if (m_damaged.contains(name)) throw InvalidModel("the blob " + name + " is damaged");
        try {
            return readSound(name, largest);
        } catch (const InvalidModel&) {
            m_damaged.insert(name);
            throw;
        }
    }

    Bytes readSound(const std::string& name, std::uint64_t largest) const {
        try {
            const fs::path file = m_blobs / name;
            if (regularFileSize(file) > largest) throw InvalidModel("the blob " + name + " is too large");
            Bytes bytes = readFile(file);
            if (hashOf(bytes) == name) return bytes;
        } catch (const FileError& error) {
            throw InvalidModel(error.what());
        }
        throw InvalidModel("the blob " + name + " is damaged");
    }

    /// Steps have most of their fuzzy systems and strokes in common.
    void share(Project& project) const {
        if (!m_latest) return;
        for (Region& region : project.regions)
            for (const Region& other : m_latest->regions)
                if (region.system == other.system) region.system = other.system;
        for (TextureLayer& layer : project.layers) {
            const TextureLayer* former = findPart(m_latest->layers, layer.id);
            if (!former) continue;
            for (std::size_t i = 0; i < std::min(layer.strokes.size(), former->strokes.size()); ++i)
                if (layer.strokes[i] == former->strokes[i]) layer.strokes[i] = former->strokes[i];
        }
    }

    fs::path m_blobs;
    SharedParts m_shared;
    std::set<std::string> m_damaged; ///< names of blobs
    ProjectValue m_latest;
    std::vector<std::string> m_warnings;
};

/// The latest state that can be read.
struct ReadLatest {
    ProjectValue project;    ///< none where there is no such state
    std::size_t records = 0; ///< up to the state's
    std::string problem = "its first record is damaged";
};

ReadLatest readLatest(const std::vector<StoredState>& states, StateReader& reader, const Progress& progress) {
    ProgressParts attempts(progress);
    ReadLatest latest;
    for (latest.records = states.size(); latest.records > 0; --latest.records) {
        const StoredState& state = states[latest.records - 1];
        if (latest.records < states.size() && state == states[latest.records]) continue;
        try {
            latest.project = reader.read(state, attempts.nextOfRest(0.8));
            break;
        } catch (const InvalidModel& error) {
            latest.problem = error.what();
        }
    }
    return latest;
}

/// The undo list around a state that could be read.
struct ReadSteps {
    std::size_t first, last;            ///< places of the first and the last state
    std::vector<ProjectValue> projects; ///< of these places
};

ReadSteps readAround(const Replay& replay, const ProjectValue& now, StateReader& reader,
                     const Progress& progress) {
    ReadSteps read{replay.index, replay.index, {now}};
    ProgressParts steps(progress);
    const double step = 1 / static_cast<double>(replay.steps.size() + 1);
    const auto tryToRead = [&](std::size_t place) -> ProjectValue {
        try {
            return reader.read(replay.at(place), steps.next(step));
        } catch (const InvalidModel&) {
            return nullptr;
        }
    };
    while (read.first > 0) {
        ProjectValue before = tryToRead(read.first - 1);
        if (!before) break;
        read.projects.insert(read.projects.begin(), std::move(before));
        --read.first;
    }
    while (read.last < replay.steps.size()) {
        ProjectValue after = tryToRead(read.last + 1);
        if (!after) break;
        read.projects.push_back(std::move(after));
        ++read.last;
    }
    return read;
}

DocumentState stateOf(const Replay& replay, const ReadSteps& read) {
    DocumentState state;
    state.base = read.projects.front();
    for (std::size_t place = read.first + 1; place <= read.last; ++place) {
        const ReplayedStep& step = replay.steps[place - 1];
        state.steps.push_back(
            {QString::fromStdString(step.text), step.systemOf, read.projects[place - read.first]});
    }
    state.index = static_cast<int>(replay.index - read.first);
    if (replay.clean && *replay.clean >= read.first && *replay.clean <= read.last)
        state.file.clean = static_cast<int>(*replay.clean - read.first);
    return state;
}

/// The document's file, where it is still as the document knew it; else what is known from before.
void takeFile(DocumentFile& file, const JournalFile& told) {
    file.former.title = QString::fromStdString(told.formerTitle);
    if (!told.formerPath.empty()) file.former.path = told.formerPath;
    if (told.path.empty()) return;
    const fs::path path = told.path;
    const std::optional<FileVersion> version = versionOf(path);
    if (version && numbersOf(version) == told.version) {
        file.path = path;
        file.version = version;
    } else {
        file.former = {QString::fromStdString(path.filename().string()), path};
        file.clean = -1;
    }
}

} // namespace

fs::path recordsOf(const fs::path& journal) {
    return journal / "records";
}

std::optional<Replay> replayOf(const fs::path& journal, const Progress& progress) {
    try {
        const JournalRecords read = readRecords(journal, progress);
        return replay(read.records, read.records.size(), Document::mostSteps);
    } catch (const Cancelled&) {
        throw;
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

QString organNameIn(const StoredState& state) {
    const auto name = state.find("name");
    if (name == state.end() || !name->second->is_string()) return {};
    return QString::fromStdString(name->second->get<std::string>());
}

BroughtBack readJournal(const fs::path& journal, const Progress& progress) {
    ProgressParts parts(progress);
    const JournalRecords read = readRecords(journal, parts.next(0.2));
    StateReader reader(journal);
    const ReadLatest latest =
        readLatest(statesAfter(read.records, Document::mostSteps), reader, parts.next(0.4));
    if (!latest.project)
        throw FileError(journal, "holds nothing that can be read: " + latest.problem + "; discard it");
    BroughtBack back;
    back.warnings = reader.warnings();
    const Replay replayed = *replay(read.records, latest.records, Document::mostSteps);
    const ReadSteps steps = readAround(replayed, latest.project, reader, parts.rest());
    back.state = stateOf(replayed, steps);
    takeFile(back.state.file, replayed.file);
    back.view = replayed.view;
    if (!read.areWhole || latest.records < read.records.size())
        back.warnings.emplace_back("The end of the journal cannot be read: the latest edits are lost");
    if (steps.projects.size() <= replayed.steps.size())
        back.warnings.emplace_back("Some steps cannot be read: they are missing in the undo list");
    reportProgress(progress, 1);
    return back;
}

} // namespace esm
