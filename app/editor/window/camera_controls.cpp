#include "app/editor/window/camera_controls.h"

#include "app/editor/edits/photo_edits.h"
#include "app/editor/window/actions.h"
#include "app/editor/window/framed_selection.h"
#include "widgets/inputs/action_texts.h"

#include <QEvent>
#include <QTimer>

#include <algorithm>

namespace esm {

CameraControls::CameraControls(OrganView& view, Document& document, Selection& selection)
    : QObject(&view), m_view(view), m_document(document), m_selection(selection) {}

void CameraControls::connectActions(const Actions& actions) {
    for (int i = 0; i < static_cast<int>(actions.standardViews.size()); ++i)
        connect(actions.standardViews[static_cast<std::size_t>(i)], &QAction::triggered, this,
                [this, i] { m_view.showView(static_cast<StandardView>(i)); });
    connect(actions.frame, &QAction::triggered, &m_view, &OrganView::frameOrgan);
    connect(actions.frameSelection, &QAction::triggered, this, &CameraControls::frameSelection);
    connect(actions.orthographic, &QAction::toggled, &m_view, &OrganView::setOrthographic);
    connect(actions.texture, &QAction::toggled, this, [this](bool on) { m_textureWorkspace = on; });
    QAction* within = actions.lookFromWithin;
    connect(within, &QAction::triggered, this, [this, within] { lookFromWithin(*within); });
    connect(&m_view, &OrganView::cameraChanged, within,
            [this, within] { within->setChecked(m_view.isWithin()); });
    QAction* through = actions.lookThroughPhoto;
    connect(through, &QAction::triggered, this, [this, through] { lookThroughPhoto(*through); });
    connect(&m_view, &OrganView::cameraChanged, through,
            [this, through] { through->setChecked(m_view.isThrough()); });
    connect(&m_document, &Document::changed, this, &CameraControls::followPhoto);
    connect(&m_selection, &Selection::changed, this, &CameraControls::followPhoto);
    m_view.installEventFilter(this);
}

/// Of the workspace that is seen. Without a selection it is the whole organ.
void CameraControls::frameSelection() {
    const Region* region = m_selection.selectedRegion();
    const TextureLayer* layer = m_selection.selectedLayer();
    std::optional<Eigen::AlignedBox3d> box;
    if (!m_textureWorkspace && region) box = boxOf(*region);
    if (m_textureWorkspace && layer) box = boxOf(*layer, *m_document.project().mesh);
    box ? m_view.frame(*box) : m_view.frameOrgan();
}

std::optional<Camera> CameraControls::throughPhoto() const {
    const TextureLayer* layer = m_selection.selectedLayer();
    if (!layer || !layer->photo) return std::nullopt;
    const double aspect = static_cast<double>(m_view.width()) / std::max(1, m_view.height());
    return cameraThrough(layer->projector, sizeOf(*pictureOf(*layer)), *m_document.project().mesh, aspect);
}

/// A photo that was dragged meanwhile is looked through anew first.
void CameraControls::lookThroughPhoto(QAction& action) {
    const std::optional<Camera> camera = throughPhoto();
    if (m_view.isThrough() && camera == m_lookedThrough) {
        m_view.leaveThrough();
    } else if (camera) {
        m_lookedThrough = camera;
        m_view.lookThrough(*camera);
        emit message(tr("Looking through the photo: %1 goes back").arg(keyOrName(&action)));
    }
    action.setChecked(m_view.isThrough());
}

/// Numbers, undo and another selection take the view along. What the mouse drags would run away from it.
void CameraControls::followPhoto() {
    if (!m_view.isThrough() || m_view.isHolding()) return;
    const std::optional<Camera> camera = throughPhoto();
    if (!camera) return m_view.leaveThrough();
    if (camera == m_lookedThrough) return;
    m_lookedThrough = camera;
    m_view.lookThrough(*camera);
}

bool CameraControls::eventFilter(QObject*, QEvent* event) {
    if (event->type() == QEvent::Resize) QTimer::singleShot(0, this, &CameraControls::followPhoto);
    return false;
}

void CameraControls::lookFromWithin(QAction& action) {
    if (m_view.isWithin()) return m_view.leaveWithin();
    const Region* region = m_textureWorkspace ? nullptr : m_selection.selectedRegion();
    std::optional<Eigen::Vector3d> about;
    if (region && region->ellipsoid) about = region->ellipsoid->centre;
    if (m_view.lookFromWithin(about))
        emit message(tr("Within the organ: drag looks around, the wheel goes ahead, %1 leaves")
                         .arg(keyOrName(&action)));
    else
        emit message(tr("No room inside the organ there: point at a part with a wall before and behind it"));
    action.setChecked(m_view.isWithin());
}

} // namespace esm
