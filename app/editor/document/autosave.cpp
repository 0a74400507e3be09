#include "app/editor/document/autosave.h"

#include "core/exchange/project/project_file.h"

#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>

namespace esm {

namespace {

QString besideCopy(const std::filesystem::path& copy, const char* ending) {
    return QString::fromStdString(std::filesystem::path(copy).replace_extension(ending).string());
}

QString lockOf(const std::filesystem::path& copy) {
    return besideCopy(copy, ".lock");
}

/// The files with the document's title and path; a project file knows the organ's name, but not its own.
constexpr const char* titleEnding = ".title";
constexpr const char* pathEnding = ".path";

void writeNote(const std::filesystem::path& copy, const char* ending, const QString& text) {
    QFile file(besideCopy(copy, ending));
    if (file.open(QIODevice::WriteOnly)) file.write(text.toUtf8());
}

QString readNote(const std::filesystem::path& copy, const char* ending) {
    QFile file(besideCopy(copy, ending));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

void writeFormer(const std::filesystem::path& copy, const Former& former) {
    writeNote(copy, titleEnding, former.title);
    writeNote(copy, pathEnding, former.path ? QString::fromStdString(former.path->string()) : QString());
}

Former readFormer(const std::filesystem::path& copy) {
    const QString path = readNote(copy, pathEnding);
    Former former{readNote(copy, titleEnding), std::nullopt};
    if (!path.isEmpty()) former.path = path.toStdString();
    return former;
}

void removeWithNotes(const std::filesystem::path& copy) {
    std::error_code none;
    std::filesystem::remove(copy, none);
    for (const char* ending : {titleEnding, pathEnding})
        QFile::remove(besideCopy(copy, ending));
}

} // namespace

std::filesystem::path recoveryFolder() {
    const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return std::filesystem::path(data.toStdString()) / "recovery";
}

Autosave::Autosave(Document& document, std::filesystem::path folder, QObject* parent, AutosaveTimes times)
    : QObject(parent), m_document(document), m_folder(std::move(folder)),
      m_file(m_folder / (QUuid::createUuid().toString(QUuid::WithoutBraces) + ".esm").toStdString()) {
    m_rest.setInterval(times.rest);
    m_longest.setInterval(times.longest);
    for (QTimer* timer : {&m_rest, &m_longest}) {
        timer->setSingleShot(true);
        connect(timer, &QTimer::timeout, this, &Autosave::save);
    }
    connect(&document, &Document::changed, this, &Autosave::noteChange);
    connect(&document, &Document::titleChanged, this, &Autosave::noteChange);
}

Autosave::~Autosave() {
    removeCopy();
}

void Autosave::noteChange() {
    m_rest.start();
    if (!m_longest.isActive()) m_longest.start();
}

void Autosave::noteFailure(const QString& reason) {
    m_written.reset();
    if (!m_longest.isActive()) m_longest.start();
    tellFailure(reason);
}

void Autosave::noteSuccess() {
    if (m_failure.isEmpty()) return;
    tellFailure({});
    emit message(tr("Copies of unsaved work are written again"));
}

void Autosave::tellFailure(const QString& reason) {
    if (reason == m_failure) return;
    m_failure = reason;
    emit failed(reason);
}

bool Autosave::isWriting() const {
    return m_writing.valid() && m_writing.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
}

void Autosave::finish() {
    if (m_writing.valid()) m_writing.wait();
}

void Autosave::takeLock() {
    m_lock = std::make_unique<QLockFile>(lockOf(m_file));
    m_lock->setStaleLockTime(0);
    m_lock->tryLock();
}

void Autosave::removeCopy() {
    finish();
    removeWithNotes(m_file);
    m_lock.reset();
    m_written.reset();
}

void Autosave::save() {
    m_rest.stop();
    m_longest.stop();
    if (isWriting()) return noteChange();
    if (!m_document.isModified()) {
        tellFailure({});
        return removeCopy();
    }
    const Project& project = m_document.project();
    if (m_written && !difference(*m_written, project).any()) return;
    std::error_code none;
    std::filesystem::create_directories(m_folder, none);
    if (!m_lock || !m_lock->isLocked()) takeLock();
    m_written = project;
    m_writing = std::async(
        std::launch::async,
        [this, project, former = Former{m_document.title(), m_document.proposedPath()}, file = m_file] {
            try {
                saveProject(project, file); // first: where it fails, copy and title stay of one project
                writeFormer(file, former);
                QMetaObject::invokeMethod(this, &Autosave::noteSuccess, Qt::QueuedConnection);
            } catch (const std::exception& error) {
                const QString reason = QString::fromStdString(error.what());
                QMetaObject::invokeMethod(
                    this, [this, reason] { noteFailure(reason); }, Qt::QueuedConnection);
            }
        });
}

std::vector<LeftBehind> Autosave::leftBehind() const {
    std::vector<LeftBehind> left;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(m_folder, none)) {
        const auto& copy = entry.path();
        if (copy.extension() != ".esm" || copy == m_file) continue;
        QLockFile lock(lockOf(copy));
        lock.setStaleLockTime(0);
        if (lock.tryLock())
            left.push_back(
                {copy, readFormer(copy), QFileInfo(QString::fromStdString(copy.string())).lastModified()});
    }
    std::sort(left.begin(), left.end(),
              [](const LeftBehind& a, const LeftBehind& b) { return a.written > b.written; });
    return left;
}

void Autosave::takeOver(const LeftBehind& left) {
    removeCopy();
    takeLock();
    std::error_code none;
    std::filesystem::rename(left.copy, m_file, none);
    for (const char* ending : {titleEnding, pathEnding})
        QFile::rename(besideCopy(left.copy, ending), besideCopy(m_file, ending));
}

void Autosave::discard(const LeftBehind& left) {
    removeWithNotes(left.copy);
}

} // namespace esm
