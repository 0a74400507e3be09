#pragma once

#include "app/editor/document/journal_habits.h"
#include "app/editor/document/left_behind.h"
#include "app/editor/document/selection.h"

#include <QTimer>

namespace esm {

class JournalWriter;
struct JournalNews;

/// Keeps a document against the program's or the machine's sudden end: each edit is written down on another
/// thread a moment after it was made. What was written goes when the program ends as it should; what another
/// one finds was left behind.
class Journal : public QObject {
    Q_OBJECT

public:
    /// @param folder made when it is first needed
    Journal(Document& document, Selection& selection, std::filesystem::path folder, QObject* parent = nullptr,
            JournalHabits habits = {});
    ~Journal() override;

    /// Which workspace the window shows, to be shown again.
    void setWorkspace(const std::string& name);
    /// Unsaved work of programs that have ended; see leftBehindIn().
    std::vector<LeftBehind> leftBehind(const Progress& progress = {}) const {
        return leftBehindIn(m_folder, progress);
    }
    /// The document is what was left behind: that goes once this journal has all of it.
    void takeOver(LeftBehind left);
    /// Waits until all that was done is on the disk.
    void finish();
    /// Number of the latest thing to be written, as JournalHabits has it.
    std::uint64_t lastPut() const { return m_lastPut; }

signals:
    /// Why nothing can be written, once until that changes; empty when it can again, or need not any more.
    void failed(const QString& reason);
    /// Worth a word in passing.
    void message(const QString& text);

private:
    using Step = std::shared_ptr<const Project>;

    void noteReplaced();
    void noteStep();
    void noteFile();
    void noteView();
    void noteEdit(int index);
    void begin();
    void end();
    template<class Task> void put(Task task);
    void hear(const JournalNews& news);
    void noteFailure(const QString& reason);
    void noteBegun();
    void noteOutgrown();
    void tellFailure(const QString& reason);
    JournalFile file() const;
    std::vector<Step> steps() const;

    Document& m_document;
    Selection& m_selection;
    std::filesystem::path m_folder;
    bool m_isKept = false;       ///< false while nothing has been unsaved since the document was opened
    bool m_isBroken = false;     ///< nothing can be written
    bool m_isRenewed = false;    ///< it is being written anew, since it has grown too large
    std::uint64_t m_dropped = 0; ///< steps that have left the undo list since the journal began
    std::vector<Step> m_steps;   ///< as they were when it last looked
    JournalFile m_file;
    JournalView m_view;
    QString m_failure; ///< as it was told
    std::uint64_t m_lastPut = 0;
    QTimer m_retry;
    std::unique_ptr<JournalWriter> m_writer;
};

/// Where the user's journals lie.
std::filesystem::path recoveryFolder();

} // namespace esm
