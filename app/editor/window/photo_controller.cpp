#include "app/editor/window/photo_controller.h"

#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/long_work.h"
#include "app/editor/dialogs/open_dialog.h"
#include "app/editor/edits/photo_edits.h"
#include "app/editor/window/actions.h"
#include "core/authoring/layers.h"
#include "core/authoring/packing.h"
#include "core/support/errors.h"
#include "core/texture/photo/photo_format.h"

namespace esm {

PhotoController::PhotoController(QWidget& window, Document& document, std::function<Camera()> camera)
    : QObject(&window), m_window(window), m_document(document), m_camera(std::move(camera)) {}

void PhotoController::connectActions(const Actions& actions) {
    connect(actions.addPhoto, &QAction::triggered, this, &PhotoController::choosePhoto);
    connect(actions.addPaint, &QAction::triggered, this, &PhotoController::addPaint);
}

void PhotoController::choosePhoto() {
    const QString filter = fileFilter(tr("Photos"), photoFileEndings()) + tr(";;All files (*)");
    const auto file = chooseFile(&m_window, tr("Add photo"), FileKind::Photo, filter, m_document.path());
    if (file) addPhoto(*file);
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

void PhotoController::addPhoto(const std::filesystem::path& file) {
    attempt(&m_window, tr("The photo cannot be added"), [&] {
        auto photo = computeLong(
            &m_window, tr("Reading %1").arg(fileName(file)),
            [&](const Progress& progress) { return loadPhoto(file, progress); }, Cancelling::Offered);
        const auto atlas = atlasForPhotos();
        const Projector projector = projectorFromCamera(m_camera(), photo->image, *m_document.project().mesh);
        const LayerId added = m_document.newLayerId();
        m_document.edit(tr("Add photo"),
                        [&](Project& project) { esm::addPhoto(project, added, photo, projector, atlas); });
        emit photoAdded();
        emit message(tr("Added %1").arg(fileName(file)));
    });
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
