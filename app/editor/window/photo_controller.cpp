#include "app/editor/window/photo_controller.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/box_setup.h"
#include "app/editor/dialogs/long_work.h"
#include "app/editor/dialogs/open_dialog.h"
#include "app/editor/edits/layer_edits.h"
#include "app/editor/edits/photo_edits.h"
#include "app/editor/window/actions.h"
#include "core/authoring/layers.h"
#include "core/authoring/packing.h"
#include "core/authoring/photo_replacement.h"
#include "core/support/angles.h"
#include "core/support/errors.h"
#include "core/texture/photo/photo_format.h"
#include "widgets/inputs/action_texts.h"

#include <QPushButton>

#include <algorithm>

namespace esm {

namespace {

/// The camera turned about the organ for one of some photos: the first stays before it, the others come to
/// its right and left by turns.
Camera fannedOut(const Camera& camera, std::size_t photo, std::size_t photos) {
    const double apart = std::min(toRadians(60), toRadians(360) / static_cast<double>(photos));
    const std::size_t places = (photo + 1) / 2;
    const double side = photo % 2 == 1 ? 1 : -1;
    return orbited(camera, side * apart * static_cast<double>(places), 0);
}

} // namespace

PhotoController::PhotoController(QWidget& window, Document& document, Selection& selection,
                                 std::function<Camera()> camera)
    : QObject(&window), m_window(window), m_document(document), m_selection(selection),
      m_camera(std::move(camera)) {}

void PhotoController::connectActions(const Actions& actions) {
    connect(actions.addPhoto, &QAction::triggered, this, &PhotoController::choosePhotos);
    connect(actions.addPaint, &QAction::triggered, this, &PhotoController::addPaint);
    connect(actions.hidePhoto, &QAction::triggered, this, [this] {
        if (const auto layer = m_selection.photo()) showOrHide(m_document, *layer);
    });
    connect(actions.duplicatePhoto, &QAction::triggered, this, [this] {
        if (const auto layer = m_selection.photo()) esm::duplicateLayer(m_document, *layer);
    });
    connect(actions.replacePhoto, &QAction::triggered, this, &PhotoController::chooseReplacement);
    const auto update = [this, actions] { enable(actions); };
    connect(&m_document, &Document::changed, this, update);
    connect(&m_selection, &Selection::changed, this, update);
    update();
}

void PhotoController::enable(const Actions& actions) {
    for (QAction* action : {actions.hidePhoto, actions.duplicatePhoto})
        esm::enable(action, m_selection.selectedLayer(), whatItDoes(action), tr("No photo is selected"));
    const TextureLayer* layer = m_selection.selectedLayer();
    esm::enable(actions.replacePhoto, layer && layer->photo, whatItDoes(actions.replacePhoto),
                layer ? tr("The selected layer has no photo, it is painted") : tr("No photo is selected"));
}

void PhotoController::choosePhotos() {
    const QString filter = fileFilter(tr("Photos"), photoFileEndings()) + tr(";;All files (*)");
    addPhotos(chooseFiles(&m_window, tr("Add photos"), FileKind::Photo, filter, m_document.path()));
}

std::shared_ptr<const Atlas> PhotoController::atlasForPhotos() {
    const Project project = m_document.project();
    if (project.mesh->triangles.empty())
        throw InvalidModel(tr("This model has no surface to lay a photo on.").toStdString());
    if (project.atlas) return project.atlas;
    return std::make_shared<const Atlas>(computeLong(
        &m_window, tr("Packing the texture"),
        [&](const Progress& progress) { return packFitting(*project.mesh, project.texture.atlas, progress); },
        Cancelling::Offered));
}

void PhotoController::addPhotos(const std::vector<std::filesystem::path>& files) {
    if (files.empty()) return;
    const QString failed =
        files.size() > 1 ? tr("The photos cannot be added") : tr("The photo cannot be added");
    ReadPhotos read;
    const bool isAdded = attempt(&m_window, failed, [&] {
        read = readPhotos(files);
        if (read.photos.empty()) throw InvalidModel(read.refused);
        lay(read.photos);
    });
    if (isAdded) tell(&m_window, tr("Not every photo was added"), read.refused);
}

PhotoController::ReadPhotos PhotoController::readPhotos(const std::vector<std::filesystem::path>& files) {
    const QString title = files.size() > 1 ? tr("Reading %1 photos").arg(files.size())
                                           : tr("Reading %1").arg(fileName(files.front()));
    const auto read = [&](const Progress& progress) {
        ReadPhotos result;
        ProgressParts parts(progress);
        for (std::size_t i = 0; i < files.size(); ++i) {
            const Progress part = parts.nextOfRest(1.0 / static_cast<double>(files.size() - i));
            try {
                result.photos.push_back(loadPhoto(files[i], part));
            } catch (const Cancelled&) {
                throw;
            } catch (const std::exception& error) {
                result.refused.push_back(reasonOf(error));
            }
        }
        return result;
    };
    return computeLong(&m_window, title, read, Cancelling::Offered);
}

/// The first of them lies on top, as it is the first in the list. Several are fanned out around the organ, so
/// that each can be seen and grasped.
void PhotoController::lay(const std::vector<std::shared_ptr<const Photo>>& photos) {
    const auto atlas = atlasForPhotos();
    const Camera camera = m_camera();
    const QString text = photos.size() > 1 ? tr("Add %1 photos").arg(photos.size()) : tr("Add photo");
    std::vector<LayerId> added;
    for (std::size_t i = 0; i < photos.size(); ++i)
        added.push_back(m_document.newLayerId());
    m_document.edit(text, [&](Project& project) {
        for (std::size_t i = photos.size(); i-- > 0;)
            esm::addPhoto(
                project, added[i], photos[i],
                projectorFromCamera(fannedOut(camera, i, photos.size()), photos[i]->image, *project.mesh),
                atlas);
    });
    emit photoAdded();
    emit message(photos.size() > 1
                     ? tr("Added %1 photos, around the organ: drag each to its place").arg(photos.size())
                     : tr("Added %1").arg(QString::fromStdString(photos.front()->fileName)));
}

void PhotoController::chooseReplacement() {
    const QString filter = fileFilter(tr("Photos"), photoFileEndings()) + tr(";;All files (*)");
    const auto file = chooseFile(&m_window, tr("Replace photo"), FileKind::Photo, filter, m_document.path());
    if (file) replacePhoto(*file);
}

void PhotoController::replacePhoto(const std::filesystem::path& file) {
    const TextureLayer* selected = m_selection.selectedLayer();
    if (!selected || !selected->photo) return;
    const TextureLayer before = *selected;
    attempt(&m_window, tr("The photo cannot be replaced"), [&] {
        const auto photo = computeLong(
            &m_window, tr("Reading %1").arg(fileName(file)),
            [&](const Progress& progress) { return loadPhoto(file, progress); }, Cancelling::Offered);
        if (!haveOneShape(before.photo->image, photo->image) && !mayChangeShape(*before.photo, *photo))
            return;
        const TextureLayer after = computeLong(
            &m_window, tr("Preparing %1").arg(fileName(file)),
            [&](const Progress& progress) { return withPhoto(before, photo, progress); },
            Cancelling::Offered);
        m_document.edit(tr("Replace photo"),
                        [&](Project& project) { partOf(project.layers, before.id) = after; });
        const std::vector<std::string> remarks = replacementRemarks(before, after);
        emit message(remarks.empty() ? tr("Replaced by %1").arg(fileName(file))
                                     : tr("Replaced: %1").arg(QString::fromStdString(remarks.back())));
    });
}

bool PhotoController::mayChangeShape(const Photo& before, const Photo& after) {
    const auto size = [](const Photo& photo) {
        return tr("%1 is %2 × %3 pixels")
            .arg(QString::fromStdString(photo.fileName))
            .arg(photo.image.width)
            .arg(photo.image.height);
    };
    QMessageBox box(QMessageBox::Question, tr("Replace photo"),
                    tr("The new photo has another shape. Replace?"), QMessageBox::Cancel, &m_window);
    QPushButton* replace = box.addButton(tr("&Replace"), QMessageBox::AcceptRole);
    setUpBox(box, "replacePhotoBox");
    box.setInformativeText(
        tr("%1, %2. Its height and its middle stay where they are on the organ, and it shows "
           "more or less at its sides. Mask and landmarks stay on the same tissue.")
            .arg(size(before), size(after)));
    ask(m_window, [&] { return box.exec(); });
    return box.clickedButton() == replace;
}

void PhotoController::addPaint() {
    attempt(&m_window, tr("The layer cannot be added"), [&] {
        const auto atlas = atlasForPhotos();
        const LayerId added = m_document.newLayerId();
        m_document.edit(tr("Add paint layer"),
                        [&](Project& project) { addPaintLayer(project, added, atlas); });
        emit paintAdded();
    });
}

} // namespace esm
