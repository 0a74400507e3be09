#include "app/editor/window/main_window.h"

#include "app/editor/dialogs/screen_room.h"
#include "app/editor/document/journal.h"
#include "app/editor/edits/preparation_edits.h"
#include "app/editor/panels/texture/photo_dialog.h"
#include "app/editor/window/camera_controls.h"
#include "app/editor/window/columns.h"
#include "app/editor/window/device_controller.h"
#include "app/editor/window/edit_controller.h"
#include "app/editor/window/export_controller.h"
#include "app/editor/window/export_notice.h"
#include "app/editor/window/file_controller.h"
#include "app/editor/window/help.h"
#include "app/editor/window/history_window.h"
#include "app/editor/window/layout.h"
#include "app/editor/window/measure_controller.h"
#include "app/editor/window/peek_key.h"
#include "app/editor/window/photo_controller.h"
#include "app/editor/window/play_controller.h"
#include "app/editor/window/poke_screen.h"
#include "app/editor/window/recovery.h"
#include "app/editor/window/reference_window.h"
#include "app/editor/window/scene_note.h"
#include "app/editor/window/shortcut_controller.h"
#include "app/editor/window/shortcuts.h"
#include "app/editor/window/slow_motion.h"
#include "app/editor/window/start_controller.h"
#include "app/editor/window/status_line.h"
#include "app/editor/window/tool_controller.h"
#include "app/editor/window/tool_strip.h"
#include "app/editor/window/top_bar.h"
#include "app/editor/window/view_bar.h"
#include "app/editor/window/view_controller.h"
#include "app/editor/window/view_settings.h"
#include "app/editor/workers/preview.h"
#include "app/editor/workers/virtual_test.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/icon.h"

#include <QCloseEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QSettings>
#include <QStackedWidget>
#include <QTimer>

namespace esm {

namespace {

constexpr int widestTitle = 300;

std::vector<std::filesystem::path> localFiles(const QMimeData& data) {
    std::vector<std::filesystem::path> files;
    for (const QUrl& url : data.urls())
        if (url.isLocalFile()) files.emplace_back(url.toLocalFile().toStdString());
    return files;
}

} // namespace

MainWindow::MainWindow(Project project)
    : m_document(new Document(std::move(project), this)), m_selection(new Selection(*m_document)),
      m_preparations(new PreparationEdits(*m_document, *m_selection)), m_preview(new Preview(this)),
      m_actions(createActions(this, m_document->undoStack())), m_view(new OrganView(this)),
      m_landmarking(new Landmarking(*m_document, *m_selection, this)),
      m_virtualTest(new VirtualTest(*m_document, *m_preview, this)),
      m_poke(new PokeTest(*m_document, *m_preview, this)),
      m_tools(
          new ToolController(*m_view, {*m_document, *m_selection, *m_preview, *m_landmarking, *m_virtualTest,
                                       *m_actions.showRegions, *m_actions.showProjector})),
      m_viewController(new ViewController(*m_view, *m_document, *m_selection, *m_preview)),
      m_pokeScreen(new PokeScreen(*m_view, *m_viewController, *m_preview, *m_poke)),
      m_cameraControls(new CameraControls(*m_view, *m_document, *m_selection)) {
    m_workspaces = new Workspaces(*this, m_actions);
    m_status = new StatusLine(*statusBar());
    m_slowMotion = new SlowMotion(*m_view, *m_document);
    m_measure = new MeasureController(*m_document, *m_preview, *m_virtualTest, *m_poke, this);
    makeControllers();
    buildWindow();
    connectParts();
    connectStatusLine();
    connectStart();
    m_workspaces->show();
    keepControlKeys(*this);
    giveKeysHome(*this, *m_view);
    setAcceptDrops(true);
    setWindowIcon(icon(QStringLiteral("app")));
    resize(QSize(1440, 900).boundedTo(roomOnScreen(*this)));
    showTitle();
    noteScene();
    m_play->showAlive();
}

void MainWindow::makeControllers() {
    m_photos = new PhotoController(*this, *m_document, *m_selection, [this] { return m_view->camera(); });
    m_files = new FileController(*this, *m_document, *m_photos, [this] {
        return EditorState{m_workspaces->chosen(), m_preview->isToPlay()};
    });
    m_files->exports().offerPoke(*m_poke);
    m_edits = new EditController(*this, *m_document, *m_selection, *m_view);
    m_device = new DeviceController(*m_view, *m_document, *m_selection,
                                    *new MotionDevice(MotionDevice::serviceSocket(), this));
    m_journal = new Journal(*m_document, *m_selection, recoveryFolder(), this);
    m_play = new PlayController(*this, *m_preview);
}

void MainWindow::buildWindow() {
    m_title = new QLabel(menuBar());
    m_title->setObjectName(QStringLiteral("documentName"));
    menuBar()->setCornerWidget(m_title, Qt::TopRightCorner);
    m_pages = new QStackedWidget(this);
    m_pages->addWidget(stacked(buildViews()));
    setCentralWidget(m_pages);
    buildMenus(*this, m_actions);
    addToolBar(Qt::TopToolBarArea, new TopBar(m_actions, m_tools->makeOptions(ToolOptions::Bar), this));
    addToolBar(Qt::LeftToolBarArea, new ToolStrip(m_actions, this));
    addColumns(*m_workspaces, {*m_document, *m_selection, *m_preparations, *m_preview, *m_landmarking,
                               m_measure->column(), *m_tools, m_actions, [this] { showLargePhoto(); }});
}

MainWindow::~MainWindow() {
    // A field that is left tells the document what was typed: now, while there is one.
    m_actions.fuzzyWindow->setChecked(false);
    delete m_largePhoto;
    delete m_reference;
    if (QWidget* focus = focusWidget()) focus->clearFocus();
}

std::vector<QWidget*> MainWindow::buildViews() {
    auto shown = m_tools->makeOptions(ToolOptions::Beside);
    shown.push_back(&m_pokeScreen->formerView());
    shown.push_back(m_view);
    return {beside(shown), &m_measure->charts()};
}

void MainWindow::showLargePhoto() {
    if (!m_largePhoto) {
        m_largePhoto = new PhotoDialog(*m_document, *m_preparations, this);
        m_largePhoto->setAttribute(Qt::WA_DeleteOnClose);
    }
    m_largePhoto->show();
    m_largePhoto->raise();
    m_largePhoto->activateWindow();
}

void MainWindow::connectParts() {
    m_viewController->connectActions(m_actions);
    m_pokeScreen->connectActions(m_actions);
    new PeekKey(*m_actions.showBare);
    m_cameraControls->connectActions(m_actions);
    auto* bar = new ViewBar(m_actions, m_view);
    connect(bar, &ViewBar::cutChanged, m_viewController,
            [this, bar] { m_viewController->setCut(bar->cut()); });
    m_tools->connectActions(m_actions);
    m_measure->connectParts(*m_workspaces, m_actions);
    connect(m_measure, &MeasureController::filmAsked, m_pokeScreen,
            [this] { m_pokeScreen->saveFilm(*m_document); });
    m_files->connectActions(m_actions);
    m_photos->connectActions(m_actions);
    m_edits->connectActions(m_actions);
    m_play->connectActions(m_actions);
    m_device->connectActions(m_actions);
    m_shortcuts = new ShortcutController(*this, m_actions);
    connect(m_photos, &PhotoController::photoAdded, m_actions.texture, &QAction::trigger);
    connect(m_photos, &PhotoController::paintAdded, m_actions.texture, &QAction::trigger);
    connect(m_photos, &PhotoController::paintAdded, m_actions.tool(QStringLiteral("brush")),
            &QAction::trigger);
    connect(m_edits, &EditController::regionAdded, m_actions.tissue, &QAction::trigger);
    connect(m_edits, &EditController::regionAdded, m_actions.tool(QStringLiteral("region")),
            &QAction::trigger);
    connect(m_slowMotion, &SlowMotion::fewerNodesAsked, m_edits, &EditController::simulateNodes);
    connect(m_document, &Document::titleChanged, this, &MainWindow::showTitle);
    connect(m_document, &Document::changed, this, &MainWindow::followDocument);
    connect(m_actions.history, &QAction::triggered, this, &MainWindow::showHistory);
    connect(m_actions.referenceWindow, &QAction::triggered, this, &MainWindow::showReference);
    connect(m_workspaces, &Workspaces::shown, m_journal,
            [this](Workspace workspace) { m_journal->setWorkspace(wordOf(workspace)); });
    auto* exported = new ExportNotice(*m_view, *m_document);
    connect(&m_files->exports(), &ExportController::exported, exported, &ExportNotice::show);
    connect(m_actions.quit, &QAction::triggered, this, &QWidget::close);
    connect(m_actions.lightTheme, &QAction::toggled, this, &MainWindow::setTheme);
    connect(m_actions.keys, &QAction::triggered, this, [this] { showKeys(this, m_actions); });
    connect(m_actions.about, &QAction::triggered, this, [this] { showAbout(this); });
}

void MainWindow::followDocument(const Change& change) {
    if (change.name) showTitle();
    if (change.mesh) m_showsGreeting = false;
    if (change.scene) noteScene();
    if (change.mesh) m_play->endGentleMotion(); // an organ of the user's own rests until it is touched
}

void MainWindow::connectStatusLine() {
    connect(m_files, &FileController::message, m_status, &StatusLine::showMessage);
    connect(m_photos, &PhotoController::message, m_status, &StatusLine::showMessage);
    connect(m_measure, &MeasureController::message, m_status, &StatusLine::showMessage);
    connect(m_pokeScreen, &PokeScreen::message, m_status, &StatusLine::showMessage);
    connect(m_tools, &ToolController::message, m_status, &StatusLine::showMessage);
    connect(m_shortcuts, &ShortcutController::message, m_status, &StatusLine::showMessage);
    connect(m_device, &DeviceController::message, m_status, &StatusLine::showMessage);
    connect(m_cameraControls, &CameraControls::message, m_status, &StatusLine::showMessage);
    connect(m_viewController, &ViewController::message, m_status, &StatusLine::showMessage);
    connect(m_viewController, &ViewController::redrawn, m_status, &StatusLine::showAside);
    connect(m_viewController, &ViewController::redrawing, m_status, &StatusLine::showWork);
    connect(m_viewController, &ViewController::pictureFailed, m_status, &StatusLine::showPictureFailure);
    connect(m_journal, &Journal::message, m_status, &StatusLine::showMessage);
    connect(m_journal, &Journal::failed, m_status, &StatusLine::showJournalFailure);
    connect(m_view, &OrganView::drawn, m_status, &StatusLine::countPicture);
    const auto showStatus = [this] {
        const PreviewStatus status = m_preview->status();
        m_status->showStatus(status);
        m_slowMotion->showStatus(status);
    };
    connect(m_preview, &Preview::statusChanged, m_status, showStatus);
    auto* slow = new QTimer(this);
    connect(slow, &QTimer::timeout, m_status, showStatus);
    slow->start(500);
}

void MainWindow::openFiles(const std::vector<std::filesystem::path>& files) {
    m_files->openAll(files);
}

void MainWindow::offerLeftBehind(Journal& journal) {
    if (const auto view = esm::offerLeftBehind(*this, *m_document, journal)) showAgain(*view);
}

void MainWindow::showAgain(const JournalView& view) {
    if (view.workspace.empty()) return;
    m_workspaces->choose(fromWord<Workspace>(view.workspace).value_or(Workspace::Tissue));
    m_selection->setRegion(view.region);
    m_selection->setPhoto(view.photo);
}

void MainWindow::connectStart() {
    m_start = new StartController(*this, *m_pages, m_actions, *m_workspaces, *m_files);
    m_firstSteps = new FirstSteps(*m_view, *m_document, *m_preview);
    m_start->connectSteps(*m_firstSteps);
    connect(m_start, &StartController::left, this, &MainWindow::showTitle);
    connect(&m_files->exports(), &ExportController::exported, m_firstSteps, &FirstSteps::noteHandover);
    connect(m_document, &Document::replaced, this, &MainWindow::showAsLeft);
    connect(m_document, &Document::changed, m_start, &StartController::leave);
    // Behind the start page lies the organ that the window began with.
    connect(m_files, &FileController::closed, this, [this, greeting = m_document->project()] {
        m_document->replace(greeting, std::nullopt);
        m_showsGreeting = true;
        noteScene();
        m_start->show();
        m_preview->setPlaying(false);
    });
}

void MainWindow::showAsLeft() {
    m_firstSteps->end();
    const auto& left = m_document->project().editor;
    m_preview->setPlaying(!left || left->plays);
    if (left) m_workspaces->choose(left->workspace);
}

void MainWindow::showHistory() {
    if (!m_history) m_history = new HistoryWindow(*m_document, this);
    m_history->show();
    m_history->raise();
    m_history->activateWindow();
}

void MainWindow::showReference() {
    if (!m_reference) m_reference = new ReferenceWindow(*m_document, *m_selection, this);
    m_reference->setVisible(!m_reference->isVisible());
}

void MainWindow::showTitle() {
    const QString mark = m_document->isModified() ? QStringLiteral(" •") : QString();
    m_title->ensurePolished();
    // At the right end the menus stay where they are whatever the name; with the mark before it, so does the
    // name.
    const QString shown =
        m_title->fontMetrics().elidedText(m_document->title(), Qt::ElideMiddle, widestTitle);
    m_title->setText(m_document->isModified() ? QStringLiteral("• ") + shown : shown);
    const auto& path = m_document->path();
    m_title->setToolTip(path ? QString::fromStdString(path->string()) : m_document->title());
    menuBar()->setCornerWidget(m_title, Qt::TopRightCorner);
    setWindowTitle(m_document->title() + mark + QStringLiteral(" – ") + tr("Elastodynamic Shape Modeler"));
}

void MainWindow::noteScene() {
    // Who starts the program asked for no scene.
    const SceneNote note = m_showsGreeting ? SceneNote{} : sceneNote(m_document->project().scene);
    m_status->showNote(note.title, withKeys(note.explanation, m_actions));
}

void MainWindow::setTheme(bool light) {
    const Theme theme = light ? Theme::Light : Theme::Dark;
    applyTheme(*qApp, theme);
    m_viewController->setTheme(theme);
}

void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    // The view has its size only now.
    if (!event->spontaneous()) QTimer::singleShot(0, m_view, &OrganView::frameOrgan);
}

void MainWindow::restore() {
    const QSettings settings;
    restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray());
    m_actions.lightTheme->setChecked(settings.value(QStringLiteral("lightTheme")).toBool());
    restoreView(settings, m_actions);
    m_shortcuts->restore(settings);
}

void MainWindow::start(const std::vector<std::filesystem::path>& files) {
    m_start->show();
    m_preview->setPlaying(false);
    QTimer::singleShot(0, this, [this, files] {
        offerLeftBehind(*m_journal);
        openFiles(files);
    });
}

void MainWindow::closeEvent(QCloseEvent* event) {
    event->setAccepted(m_files->mayLeaveProject());
    if (!event->isAccepted()) return;
    m_actions.fuzzyWindow->setChecked(false);
    QSettings settings;
    settings.setValue(QStringLiteral("geometry"), saveGeometry());
    settings.setValue(QStringLiteral("lightTheme"), m_actions.lightTheme->isChecked());
    saveView(settings, m_actions);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!localFiles(*event->mimeData()).empty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    const auto files = localFiles(*event->mimeData());
    // After the drop is over, so that its source does not wait for a dialog.
    QTimer::singleShot(0, this, [this, files] { openFiles(files); });
}

} // namespace esm
