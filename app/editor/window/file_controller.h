#pragma once

#include "app/editor/document/document.h"

#include <QObject>
#include <QWidget>

#include <functional>

namespace esm {

struct Actions;
class ExportController;
class ImportController;
class PhotoController;
class RecentMenu;

/// Opens and saves projects. Files that become something else go to who takes them.
class FileController : public QObject {
    Q_OBJECT

public:
    /// @param editorState what is saved of the window
    FileController(QWidget& window, Document& document, PhotoController& photos,
                   std::function<EditorState()> editorState);

    void connectActions(const Actions& actions);

    /// Any file that the program understands, by its ending: a project, a mesh or a photo.
    void openAny(const std::filesystem::path& file);
    /// One after the other.
    void openAll(const std::vector<std::filesystem::path>& files);
    void openProject(const std::filesystem::path& file);
    /// Whether it was opened.
    bool openSample(const std::string& name);
    /// One that was opened before, and may be gone.
    void openRecent(const QString& file);
    bool saveTo(const std::filesystem::path& file);
    ExportController& exports() { return *m_exports; }

    /// True when nothing would be lost: nothing is unsaved, it was saved now, or the user gives it up.
    bool mayLeaveProject();

signals:
    void message(const QString& text);
    /// The user closed the project; nothing unsaved is lost.
    void closed();

private:
    void chooseProject();
    bool save();
    bool saveAs();
    void close();
    void commitTyping();
    bool mayLoseUnfinished();
    void noteOpened(const std::filesystem::path& file);
    bool mayReplaceChanged(const std::filesystem::path& file);
    void write(const std::filesystem::path& file, const std::optional<FileVersion>& replaced);

    QWidget& m_window;
    Document& m_document;
    std::function<EditorState()> m_editorState;
    PhotoController& m_photos;
    ImportController* m_imports;
    ExportController* m_exports;
    RecentMenu* m_recent = nullptr;
};

} // namespace esm
