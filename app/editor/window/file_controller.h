#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/file_memory.h"
#include "app/editor/document/journal.h"
#include "core/render/camera.h"

#include <QObject>
#include <QWidget>

namespace esm {

struct Actions;
class RecentMenu;

/// Opens, imports, saves, hands over and adds photos: what the window does with files.
class FileController : public QObject {
    Q_OBJECT

public:
    /// What is asked of the window.
    struct Asked {
        std::function<Camera()> camera;           ///< where the user looks from, for new photos
        std::function<EditorState()> editorState; ///< to be saved
    };
    FileController(QWidget& window, Document& document, Asked asked);

    void connectActions(const Actions& actions);

    /// Any file that the program understands, by its ending: a project, a mesh or a photo.
    void openAny(const std::filesystem::path& file);
    /// One after the other.
    void openAll(const std::vector<std::filesystem::path>& files);
    void openProject(const std::filesystem::path& file);
    void importMesh(const std::filesystem::path& file);
    /// Whether it was opened.
    bool openSample(const std::string& name);
    /// One that was opened before, and may be gone.
    void openRecent(const QString& file);
    void addPhoto(const std::filesystem::path& file);
    void addPaint();
    bool saveTo(const std::filesystem::path& file);
    /// In the format that the file's ending says; the first there is where it says none.
    void exportTo(const std::filesystem::path& file);
    /// Offers the latest unsaved work that a sudden end of the program left behind.
    void offerLeftBehind(Journal& journal);

    /// True when nothing would be lost: nothing is unsaved, it was saved now, or the user gives it up.
    bool mayLeaveProject();

signals:
    void message(const QString& text);
    /// A simulator can read this file now.
    void exported(const QString& file);
    void photoAdded();
    void paintAdded();
    /// Unsaved work came back; what the window showed of it.
    void broughtBack(const esm::JournalView& view);

private:
    void chooseProject();
    void chooseMesh();
    void choosePhoto();
    bool save();
    bool saveAs();
    void chooseExport();
    void commitTyping();
    bool mayLoseUnfinished();
    void noteOpened(const std::filesystem::path& file);
    bool mayReplaceChanged(const std::filesystem::path& file);
    void write(const std::filesystem::path& file, const std::optional<FileVersion>& replaced);
    std::optional<std::filesystem::path> chooseFile(FileKind kind, const QString& title,
                                                    const QString& filter);
    std::shared_ptr<const Atlas> atlasForPhotos();

    QWidget& m_window;
    Document& m_document;
    Asked m_asked;
    RecentMenu* m_recent = nullptr;
};

} // namespace esm
