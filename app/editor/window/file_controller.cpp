#include "app/editor/window/file_controller.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/box_setup.h"
#include "app/editor/dialogs/long_work.h"
#include "app/editor/dialogs/open_dialog.h"
#include "app/editor/dialogs/save_dialog.h"
#include "app/editor/dialogs/thin_wall_text.h"
#include "app/editor/window/actions.h"
#include "app/editor/window/export_controller.h"
#include "app/editor/window/import_controller.h"
#include "app/editor/window/photo_controller.h"
#include "app/editor/window/recent_menu.h"
#include "core/exchange/meshes/mesh_file.h"
#include "core/exchange/project/project_file.h"
#include "core/samples/samples.h"
#include "core/texture/photo/photo_format.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>

#include <algorithm>
#include <utility>

namespace esm {

namespace {

QStringList listOf(const std::vector<std::string>& words) {
    QStringList list;
    for (const auto& word : words)
        list << QString::fromStdString(word);
    return list;
}

QStringList photoEndings() {
    return listOf(photoFileEndings());
}

QStringList meshEndings() {
    return listOf(meshFileEndings());
}

QString endingWithoutDot(const std::filesystem::path& file) {
    return QFileInfo(QString::fromStdString(file.string())).suffix().toLower();
}

bool isPhoto(const std::filesystem::path& file) {
    return photoEndings().contains(endingWithoutDot(file));
}

std::filesystem::path toPath(const QString& file) {
    return std::filesystem::path(file.toStdString());
}

} // namespace

FileController::FileController(QWidget& window, Document& document, PhotoController& photos,
                               std::function<EditorState()> editorState)
    : QObject(&window), m_window(window), m_document(document), m_editorState(std::move(editorState)),
      m_photos(photos),
      m_imports(new ImportController(window, document, [this] { return mayLeaveProject(); })),
      m_exports(new ExportController(window, document)) {
    connect(m_imports, &ImportController::imported, this, [this](const std::filesystem::path& file) {
        noteOpened(file);
        const QString imported = tr("Imported %1").arg(fileName(file)),
                      thin = thinWallWarning(m_document.project());
        emit message(thin.isEmpty() ? imported : imported + QStringLiteral(": ") + thin);
    });
}

void FileController::connectActions(const Actions& actions) {
    connect(actions.open, &QAction::triggered, this, &FileController::chooseProject);
    connect(actions.import, &QAction::triggered, m_imports, &ImportController::chooseMesh);
    connect(actions.save, &QAction::triggered, this, &FileController::save);
    connect(actions.saveAs, &QAction::triggered, this, &FileController::saveAs);
    connect(actions.exportPackage, &QAction::triggered, this, [this] {
        commitTyping();
        m_exports->choose();
    });
    connect(actions.close, &QAction::triggered, this, &FileController::close);
    m_recent = new RecentMenu(*actions.recent, this);
    connect(m_recent, &RecentMenu::chosen, this, &FileController::openRecent);
    for (const auto& sample : actions.samples) {
        const std::string name = sample.first;
        connect(sample.second, &QAction::triggered, this, [this, name] { openSample(name); });
    }
}

/// A window beside the main one has its keys in force too, and is meant where it is the active one.
void FileController::close() {
    QWidget* active = QApplication::activeWindow();
    if (active && active != &m_window) {
        active->close();
        return;
    }
    if (mayLeaveProject()) emit closed();
}

void FileController::commitTyping() {
    // Neither a menu's key nor the window's end takes the focus from a field, which would make it count. The
    // field may stand in a window beside the main one.
    const QPointer<QWidget> focus = QApplication::focusWidget();
    if (!focus) return;
    focus->clearFocus();
    if (focus && focus->isVisible()) focus->setFocus();
}

bool FileController::mayLeaveProject() {
    commitTyping();
    const QString& unfinished = m_document.unfinished();
    if (!m_document.isModified()) return unfinished.isEmpty() || mayLoseUnfinished();
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                    tr("Save the changes to %1?").arg(m_document.title()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &m_window);
    setUpBox(box, "unsavedBox");
    box.setInformativeText((tr("Without saving they are lost.") + '\n' + unfinished).trimmed());
    const int answer = ask(m_window, [&] { return box.exec(); });
    return answer == QMessageBox::Save ? save() : answer == QMessageBox::Discard;
}

bool FileController::mayLoseUnfinished() {
    QMessageBox box(QMessageBox::Question, tr("Unfinished text"), tr("Leave the text as it is?"),
                    QMessageBox::Discard | QMessageBox::Cancel, &m_window);
    setUpBox(box, "unfinishedBox");
    box.setInformativeText(m_document.unfinished());
    return ask(m_window, [&] { return box.exec(); }) == QMessageBox::Discard;
}

void FileController::openAny(const std::filesystem::path& file) {
    const QString ending = endingWithoutDot(file);
    if (ending == QLatin1String("esm")) return openProject(file);
    if (isPhoto(file)) return m_photos.addPhotos({file});
    if (meshEndings().contains(ending)) return m_imports->importMesh(file);
    attempt(&m_window, tr("This file cannot be opened"), [&] {
        throw FileError(file, tr("neither a project (.esm), nor a surface (.%1), nor a photo (.%2)")
                                  .arg(meshEndings().join(QStringLiteral(", .")),
                                       photoEndings().join(QStringLiteral(", .")))
                                  .toStdString());
    });
}

void FileController::openAll(const std::vector<std::filesystem::path>& files) {
    // Photos that follow each other are added together.
    std::vector<std::filesystem::path> photos;
    const auto addPhotos = [&] { m_photos.addPhotos(std::exchange(photos, {})); };
    for (const auto& file : files) {
        if (isPhoto(file)) {
            photos.push_back(std::filesystem::absolute(file));
            continue;
        }
        addPhotos();
        openAny(std::filesystem::absolute(file));
    }
    addPhotos();
}

void FileController::openRecent(const QString& file) {
    if (QFileInfo::exists(file)) return openAny(toPath(file));
    attempt(&m_window, tr("This file cannot be opened"), [&] {
        throw FileError(
            toPath(file),
            tr("is not there; the disk, stick or network folder that holds it may be away").toStdString());
    });
}

void FileController::noteOpened(const std::filesystem::path& file) {
    addRecentFile(file);
    if (m_recent) m_recent->fill();
}

void FileController::openProject(const std::filesystem::path& file) {
    // Asked first: the answer may change the very file that is to be opened.
    if (!mayLeaveProject()) return;
    attempt(&m_window, tr("The project cannot be opened"), [&] {
        // Before it is read: a change that comes in the meantime is then noticed when it is saved.
        const auto version = versionOf(file);
        OpenedProject opened = computeLong(
            &m_window, tr("Opening %1").arg(fileName(file)),
            [&](const Progress& progress) { return esm::openProject(file, progress); }, Cancelling::Offered);
        m_document.replace(std::move(opened.project), file);
        m_document.setFileVersion(version);
        noteOpened(file);
        emit message(tr("Opened %1").arg(fileName(file)));
        tell(&m_window, tr("The project was opened, but something is wrong with it"), opened.warnings);
    });
}

bool FileController::openSample(const std::string& name) {
    return mayLeaveProject() && attempt(&m_window, tr("The sample cannot be made"), [&] {
               m_document.replace(computeLong(&m_window, tr("Making the sample"),
                                              [&](const Progress&) { return makeSample(name); }),
                                  std::nullopt);
           });
}

bool FileController::saveTo(const std::filesystem::path& file) {
    commitTyping();
    const auto version = versionOf(file);
    const bool isChanged = m_document.path() == file && version && version != m_document.fileVersion();
    if (isChanged && !mayReplaceChanged(file)) return false;
    return attempt(&m_window, tr("The project was not saved"), [&] { write(file, version); });
}

bool FileController::mayReplaceChanged(const std::filesystem::path& file) {
    QMessageBox box(QMessageBox::Warning, tr("File changed"),
                    tr("Another program has changed %1 since it was opened.").arg(fileName(file)),
                    QMessageBox::Cancel, &m_window);
    setUpBox(box, "changedFileBox");
    box.setInformativeText(
        tr("Replacing it loses that change. To keep both, cancel and save under another name."));
    QPushButton* replace = box.addButton(tr("&Replace"), QMessageBox::AcceptRole);
    ask(m_window, [&] { return box.exec(); });
    return box.clickedButton() == replace;
}

/// @param replaced the file that the user knows will go
void FileController::write(const std::filesystem::path& file, const std::optional<FileVersion>& replaced) {
    m_document.keepEditorState(m_editorState());
    const Project project = m_document.project();
    std::optional<FileVersion> written;
    runLongWork(
        &m_window, tr("Saving %1").arg(fileName(file)),
        [&](const Progress& progress) {
            const FileLock lock(file);
            if (versionOf(file) != replaced)
                throw FileError(file, tr("another program has just changed it; save again").toStdString());
            saveProject(project, file, progress);
            written = versionOf(file);
        },
        Cancelling::UntilDone);
    m_document.setFileVersion(written);
    m_document.markSaved(file, project);
    noteOpened(file);
    emit message((tr("Saved %1.").arg(fileName(file)) + ' ' + m_document.unfinished()).trimmed());
}

void FileController::chooseProject() {
    const auto file = chooseFile(&m_window, tr("Open project"), FileKind::Project, tr("Projects (*.esm)"),
                                 m_document.path());
    if (file) openProject(*file);
}

bool FileController::save() {
    return m_document.path() ? saveTo(*m_document.path()) : saveAs();
}

bool FileController::saveAs() {
    const QString ending = QStringLiteral(".esm");
    const auto& path = m_document.proposedPath();
    const QString beside = path ? QString::fromStdString(path->parent_path().string()) : QString();
    // Another name for a project that has one: beside it, unless its stick or share is gone.
    const QString folder =
        !beside.isEmpty() && QDir(beside).exists() ? beside : startFolder(FileKind::Project, std::nullopt);
    const NewFile asked{
        tr("Save project"), suggestedPath(m_document, folder, ending), tr("Projects (*.esm)"), {ending}};
    const auto file = ask(m_window, [&] { return chooseNewFile(&m_window, asked); });
    if (!file) return false;
    rememberFolder(FileKind::Project, *file);
    return saveTo(*file);
}

} // namespace esm
