#include "app/editor/window/camera_controls.h"

#include "app/editor/window/actions.h"
#include "app/editor/window/framed_selection.h"
#include "widgets/inputs/action_texts.h"

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
