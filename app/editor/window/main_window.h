#pragma once

#include "app/editor/window/actions.h"

#include <QDialog>
#include <QMainWindow>
#include <QPointer>

#include <filesystem>
#include <vector>

class QLabel;
class QStackedWidget;

namespace esm {

class CameraControls;
class DeviceController;
class Document;
class EditController;
class FileController;
class FirstSteps;
class Journal;
class Landmarking;
class MeasureController;
class OrganView;
class PhotoController;
class PlayController;
class PokeScreen;
class PokeTest;
class PreparationEdits;
class Preview;
class Selection;
class ShortcutController;
class SlowMotion;
class StartController;
class StatusLine;
class ToolController;
class ViewController;
class VirtualTest;
class Workspaces;
struct Change;
struct JournalView;
struct Project;

/// The editor's window: puts document, view, panels and controllers together.
/// Begins with an organ that is there to be replaced; start() shows the start page before it.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(Project project);
    ~MainWindow() override;

    /// As the user left the window.
    void restore();
    /// Shows the start page. Offers what an unexpected end of the program left unsaved, then opens the files:
    /// once the window is shown, and one after the other, since both ask the user.
    void start(const std::vector<std::filesystem::path>& files);

    Document& document() { return *m_document; }
    Preview& preview() { return *m_preview; }
    FileController& files() { return *m_files; }
    OrganView& view() { return *m_view; }
    const Actions& windowActions() const { return m_actions; }

    /// Offers the latest unsaved work that a sudden end of the program left behind, and shows it as it was.
    void offerLeftBehind(Journal& journal);

    /// Opens projects, imports meshes and adds photos, by the files' endings and one after the other.
    void openFiles(const std::vector<std::filesystem::path>& files);

protected:
    void showEvent(QShowEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void makeControllers();
    void buildWindow();
    std::vector<QWidget*> buildViews();
    void showLargePhoto();
    void connectParts();
    void connectStatusLine();
    void followDocument(const Change& change);
    void connectStart();
    void showAsLeft();
    void showHistory();
    void showReference();
    void showAgain(const JournalView& view);
    void showTitle();
    void noteScene();
    void setTheme(bool light);

    Document* m_document;
    bool m_showsGreeting = true; ///< the organ that the window began with
    Selection* m_selection;
    PreparationEdits* m_preparations;
    Preview* m_preview;
    Actions m_actions;
    OrganView* m_view;
    Landmarking* m_landmarking;
    VirtualTest* m_virtualTest;
    PokeTest* m_poke;
    ToolController* m_tools;
    ViewController* m_viewController;
    PokeScreen* m_pokeScreen;
    CameraControls* m_cameraControls;
    PhotoController* m_photos;
    FileController* m_files;
    Journal* m_journal;
    EditController* m_edits;
    PlayController* m_play;
    DeviceController* m_device;
    StatusLine* m_status;
    ShortcutController* m_shortcuts;
    SlowMotion* m_slowMotion;
    QLabel* m_title;
    QPointer<QDialog> m_largePhoto, m_history, m_reference;
    QStackedWidget* m_pages;
    MeasureController* m_measure;
    Workspaces* m_workspaces;
    StartController* m_start;
    FirstSteps* m_firstSteps;
};

} // namespace esm
