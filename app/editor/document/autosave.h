#pragma once

#include "app/editor/document/document.h"

#include <QLockFile>
#include <QTimer>

#include <future>
#include <memory>

namespace esm {

/// Keeps a copy of unsaved work in a folder, against the program's or the machine's sudden end. The copy goes
/// when the work is saved and when the program ends as it should; what is left behind was not saved.
class Autosave : public QObject {
    Q_OBJECT

public:
    /// @param folder made when it is first needed
    Autosave(Document& document, std::filesystem::path folder, QObject* parent = nullptr);
    ~Autosave() override;

    /// Writes the copy on another thread where something changed since the last one; done by itself every
    /// two minutes.
    void save();
    /// Waits until the copy is written.
    void finish();
    /// Copies by programs that ended before they could remove them.
    std::vector<std::filesystem::path> leftBehind() const;
    /// Makes another program's copy this one's own, to be kept until its work is saved.
    void takeOver(const std::filesystem::path& copy);

private:
    void removeCopy();

    Document& m_document;
    std::filesystem::path m_folder, m_file;
    std::unique_ptr<QLockFile> m_lock; ///< says that the copy's program still runs
    std::optional<Project> m_written;
    std::future<void> m_writing;
    QTimer m_timer;
};

/// Where the user's copies lie.
std::filesystem::path recoveryFolder();

} // namespace esm
