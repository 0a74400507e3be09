#include "app/editor/document/autosave.h"

#include "core/exchange/project_file.h"

#include <QStandardPaths>
#include <QUuid>

#include <chrono>

namespace esm {

namespace {

constexpr std::chrono::minutes autosavePeriod{2};

QString lockOf(const std::filesystem::path& copy) {
    return QString::fromStdString(std::filesystem::path(copy).replace_extension(".lock").string());
}

} // namespace

std::filesystem::path recoveryFolder() {
    const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return std::filesystem::path(data.toStdString()) / "recovery";
}

Autosave::Autosave(Document& document, std::filesystem::path folder, QObject* parent)
    : QObject(parent), m_document(document), m_folder(std::move(folder)),
      m_file(m_folder / (QUuid::createUuid().toString(QUuid::WithoutBraces) + ".esm").toStdString()) {
    connect(&m_timer, &QTimer::timeout, this, &Autosave::save);
    m_timer.start(autosavePeriod);
}

Autosave::~Autosave() {
    removeCopy();
}

void Autosave::finish() {
    if (m_writing.valid()) m_writing.wait();
}

void Autosave::removeCopy() {
    finish();
    std::error_code none;
    std::filesystem::remove(m_file, none);
    m_lock.reset();
    m_written.reset();
}

void Autosave::save() {
    if (!m_document.isModified()) return removeCopy();
    const Project& project = m_document.project();
    const bool writing =
        m_writing.valid() && m_writing.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
    if (writing || (m_written && !difference(*m_written, project).any())) return;
    std::error_code none;
    std::filesystem::create_directories(m_folder, none);
    if (!m_lock) {
        m_lock = std::make_unique<QLockFile>(lockOf(m_file));
        m_lock->setStaleLockTime(0);
        m_lock->tryLock();
    }
    m_written = project;
    m_writing = std::async(std::launch::async, [project, file = m_file] {
        try {
            saveProject(project, file);
        } catch (const std::exception&) {
            // Nobody asked for this copy; the user's own save says what is wrong.
        }
    });
}

std::vector<std::filesystem::path> Autosave::leftBehind() const {
    std::vector<std::filesystem::path> copies;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(m_folder, none)) {
        if (entry.path().extension() != ".esm" || entry.path() == m_file) continue;
        QLockFile lock(lockOf(entry.path()));
        lock.setStaleLockTime(0);
        if (lock.tryLock()) copies.push_back(entry.path());
    }
    return copies;
}

void Autosave::takeOver(const std::filesystem::path& copy) {
    removeCopy();
    m_lock = std::make_unique<QLockFile>(lockOf(m_file));
    m_lock->setStaleLockTime(0);
    m_lock->tryLock();
    std::error_code none;
    std::filesystem::rename(copy, m_file, none);
}

} // namespace esm
