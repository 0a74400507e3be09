#include "app/editor/document/left_behind.h"

#include "app/editor/document/journal_reader.h"
#include "app/editor/document/journal_store.h"
#include "core/exchange/project/project_file.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>

namespace esm {

namespace fs = std::filesystem;

namespace {

bool isJournal(const fs::path& place) {
    return place.extension() == journalEnding;
}

QString nameOf(const fs::path& file) {
    return QString::fromStdString(file.string());
}

/// Earlier versions kept title and path of a document in files beside the copy.
QString noteBeside(const fs::path& copy, const char* ending) {
    QFile file(nameOf(fs::path(copy).replace_extension(ending)));
    constexpr qint64 longestNote = 1 << 16;
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.read(longestNote)) : QString();
}

Former formerOfCopy(const fs::path& copy) {
    const QString path = noteBeside(copy, ".path");
    Former former{noteBeside(copy, ".title"), std::nullopt};
    if (!path.isEmpty()) former.path = path.toStdString();
    return former;
}

Former formerOf(const JournalFile& file) {
    if (!file.path.empty()) return {nameOf(fs::path(file.path).filename()), fs::path(file.path)};
    Former former{QString::fromStdString(file.formerTitle), std::nullopt};
    if (!file.formerPath.empty()) former.path = file.formerPath;
    return former;
}

/// Journals, and copies of earlier versions.
std::vector<fs::path> placesIn(const fs::path& folder) {
    std::vector<fs::path> places;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none))
        if (entry.path().extension() == ".esm" || isJournal(entry.path())) places.push_back(entry.path());
    return places;
}

/// False where it holds nothing that would be lost. One that cannot be read may hold something.
bool isWorthKeeping(LeftBehind& left, const Progress& progress) {
    if (!isJournal(left.place)) {
        left.former = formerOfCopy(left.place);
        return true;
    }
    const fs::path records = recordsOf(left.place);
    std::error_code none;
    if (!fs::exists(records, none)) return false;
    left.written = QFileInfo(nameOf(records)).lastModified();
    const auto replay = replayOf(left.place, progress);
    if (!replay) return true;
    left.former = formerOf(replay->file);
    if (left.former.title.isEmpty()) left.former.title = organNameIn(replay->now());
    return replay->isUnsaved();
}

} // namespace

std::vector<LeftBehind> leftBehindIn(const fs::path& folder, const Progress& progress) {
    const std::vector<fs::path> places = placesIn(folder);
    ProgressParts parts(progress);
    std::vector<LeftBehind> found;
    for (const fs::path& place : places) {
        const Progress reading = parts.next(1 / static_cast<double>(places.size()));
        reportProgress(reading, 0);
        LeftBehind left{place, {}, QFileInfo(nameOf(place)).lastModified(), lockBeside(place)};
        if (!left.lock->tryLock()) continue;
        if (isWorthKeeping(left, reading))
            found.push_back(std::move(left));
        else
            discard(left);
    }
    std::sort(found.begin(), found.end(),
              [](const LeftBehind& a, const LeftBehind& b) { return a.written > b.written; });
    reportProgress(progress, 1);
    return found;
}

void discard(const LeftBehind& left) {
    std::error_code none;
    if (isJournal(left.place)) fs::remove(recordsOf(left.place), none);
    fs::remove_all(left.place, none);
    for (const char* ending : {".title", ".path"})
        QFile::remove(nameOf(fs::path(left.place).replace_extension(ending)));
}

BroughtBack bringBack(const LeftBehind& left, const Progress& progress) {
    if (isJournal(left.place)) return readJournal(left.place, progress);
    OpenedProject opened = openProject(left.place, progress);
    BroughtBack back;
    back.state.base = std::make_shared<const Project>(std::move(opened.project));
    back.state.file.former = left.former;
    back.warnings = std::move(opened.warnings);
    return back;
}

} // namespace esm
