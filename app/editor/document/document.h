#pragma once

#include "app/editor/document/change.h"
#include "app/editor/document/edit_kind.h"
#include "core/support/file_lock.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <filesystem>
#include <functional>
#include <optional>

namespace esm {

/// Whether a project would be lost with the window: `Stored` lies in a file or can be made again.
enum class Origin { Stored, Unsaved };

/// What is known of unsaved work from before: its title, and its file if it had one.
struct Former {
    QString title;
    std::optional<std::filesystem::path> path;
};

/// A step of the undo list.
struct DocumentStep {
    QString text;
    std::optional<RegionId> systemOf; ///< as in Document::edit()
    std::shared_ptr<const Project> after;
};

/// Where a document is saved.
struct DocumentFile {
    std::optional<std::filesystem::path> path;
    std::optional<FileVersion> version; ///< as it was read or written last
    Former former;
    int clean = -1; ///< steps that are done in what lies in the file; -1 where none does
};

/// A document with its undo list.
struct DocumentState {
    std::shared_ptr<const Project> base; ///< before the first step; never null
    std::vector<DocumentStep> steps;
    int index = 0; ///< steps that are done
    DocumentFile file;
};

/// The one project the window shows: a value, where it is saved, and the edits that led to it. Only commands
/// change it; everyone else listens to changed().
class Document : public QObject {
    Q_OBJECT

public:
    static constexpr int mostSteps = 500; ///< that can be undone

    explicit Document(Project project, QObject* parent = nullptr);
    ~Document() override;

    const Project& project() const { return m_project; }
    const std::optional<std::filesystem::path>& path() const { return m_path; }
    /// The file to propose for saving: its own; while it has none, the one that replace() was told. Ask the
    /// user before writing to that one.
    const std::optional<std::filesystem::path>& proposedPath() const {
        return m_path ? m_path : m_former.path;
    }
    /// Of the document's file as it was read or written last.
    const std::optional<FileVersion>& fileVersion() const { return m_fileVersion; }
    void setFileVersion(const std::optional<FileVersion>& version) { m_fileVersion = version; }
    QUndoStack* undoStack() { return &m_undoStack; }
    bool isModified() const { return !m_undoStack.isClean(); }
    /// The file's name; while it was never saved, what replace() was told, or the organ's name.
    QString title() const;

    /// An undoable edit. Edits that follow each other with the same key, of another kind than `Alone`, become
    /// one step, until finishGesture(). Nothing happens when the edit changes nothing.
    /// @param systemOf the region whose fuzzy system is edited, as against exchanged for another one
    void edit(const QString& text, const std::function<void(Project&)>& change, const MergeKey& mergeKey = {},
              std::optional<RegionId> systemOf = {});
    /// Identities for a region or layer that an edit adds. None is given twice, undone or not.
    RegionId newRegionId() { return {++m_lastRegion}; }
    LayerId newLayerId() { return {++m_lastLayer}; }
    /// Another project takes the place of this one; nothing to undo remains.
    void replace(Project project, std::optional<std::filesystem::path> path, Origin origin = Origin::Stored,
                 Former former = {});
    /// All of it, for who keeps it; costs a few pointers for each step.
    DocumentState state() const;
    DocumentFile file() const { return {m_path, m_fileVersion, m_former, m_undoStack.cleanIndex()}; }
    /// Takes the place of this one, undo list and identities of parts included.
    void restore(const DocumentState& state);
    /// How the editor is left, for the file that is about to be written: no edit, and no change.
    void keepEditorState(const EditorState& state) { m_project.editor = state; }
    /// `written` lies in this file; the document is saved when it still is that project.
    void markSaved(const std::filesystem::path& path, const Project& written);

    /// What a step of the undo list does, with the name of the region or layer that it is about: "Shape
    /// region · Tumour".
    QString stepText(int step) const;
    /// Undoes or redoes as many steps as it takes until so many are done, as one change.
    void goTo(int stepsDone);
    /// The drag, slider move or run of arrow keys in progress is over: the next edit starts a step of its
    /// own.
    void finishGesture() { ++m_gesture; }

    /// Says of text that is to be mended before it can be an edit that it would be lost with the project.
    /// Empty where there is none.
    void setUnfinished(const QString& what) { m_unfinished = what; }
    const QString& unfinished() const { return m_unfinished; }

signals:
    void changed(const esm::Change& change);
    /// A step was made, merged into the last one, undone or redone.
    void stepped();
    /// Another document took the place of this one.
    void replaced();
    /// Title, path or modified mark.
    void titleChanged();

private:
    friend class ProjectCommand;
    struct Step {
        std::optional<RegionId> systemOf; ///< as in edit()
        bool isOfHistory;                 ///< undone or redone
    };
    void numberParts();
    void announceReplaced();
    void take(const Project& project, const Step& step);

    Project m_project;
    std::optional<std::filesystem::path> m_path;
    std::optional<FileVersion> m_fileVersion;
    Former m_former;
    QUndoStack m_undoStack;
    bool m_isBeingReplaced = false; ///< steps are no news then
    int m_gesture = 0;
    std::uint32_t m_lastRegion = 0, m_lastLayer = 0; ///< numbers that are given
    QString m_unfinished;
};

} // namespace esm
