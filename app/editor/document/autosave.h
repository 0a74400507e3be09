#pragma once

#include "app/editor/document/document.h"

#include <QDateTime>
#include <QLockFile>
#include <QTimer>

#include <chrono>
#include <future>
#include <memory>

namespace esm {

/// When the copy is written: once the edits rest, and while they do not, every now and then.
struct AutosaveTimes {
    std::chrono::milliseconds rest{3000}, longest{10000};
};

/// Unsaved work of a program that ended before it could remove its copy.
struct LeftBehind {
    std::filesystem::path copy;
    Former former; ///< of the document; empty where it is not known
    QDateTime written;
};

/// Keeps a copy of unsaved work in a folder, against the program's or the machine's sudden end. The copy goes
/// when the work is saved and when the program ends as it should; what is left behind was not saved.
class Autosave : public QObject {
    Q_OBJECT

public:
    /// @param folder made when it is first needed
    Autosave(Document& document, std::filesystem::path folder, QObject* parent = nullptr,
             AutosaveTimes times = {});
    ~Autosave() override;

    /// Writes the copy on another thread where something changed since the last one; done by itself a moment
    /// after an edit, and again after a while where the copy could not be written. Waits for nothing.
    void save();
    /// Waits until the copy is written.
    void finish();
    /// The latest first.
    std::vector<LeftBehind> leftBehind() const;
    /// Makes another program's copy this one's own, to be kept until its work is saved.
    void takeOver(const LeftBehind& left);
    static void discard(const LeftBehind& left);

signals:
    /// Why no copy can be written, once until that changes; empty when it can again, or need not any more.
    void failed(const QString& reason);
    /// Worth a word in passing.
    void message(const QString& text);

private:
    void noteChange();
    void noteFailure(const QString& reason);
    void noteSuccess();
    void tellFailure(const QString& reason);
    bool isWriting() const;
    void takeLock();
    void removeCopy();

    Document& m_document;
    std::filesystem::path m_folder, m_file;
    std::unique_ptr<QLockFile> m_lock; ///< says that the copy's program still runs
    std::optional<Project> m_written;
    QString m_failure; ///< as it was told
    std::future<void> m_writing;
    QTimer m_rest, m_longest;
};

/// Where the user's copies lie.
std::filesystem::path recoveryFolder();

} // namespace esm
