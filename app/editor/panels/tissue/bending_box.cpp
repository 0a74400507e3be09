#include "app/editor/panels/tissue/bending_box.h"

#include <QVBoxLayout>

namespace esm {

BendingBox::BendingBox(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_resists(new QCheckBox(tr("Wall resists bending"), this)) {
    m_resists->setObjectName(QStringLiteral("resistsBending"));
    m_resists->setToolTip(
        tr("A flap or a tube keeps its form, as a wall of the thickness above does: twice as "
           "thick, it resists bending four times as much. Without, the surface bends freely "
           "like a cloth"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 6, 0, 0);
    column->addWidget(m_resists);
    connect(m_resists, &QCheckBox::clicked, this, [this](bool on) {
        m_document.edit(on ? tr("Resist bending") : tr("Bend freely"),
                        [on](Project& project) { project.base.resistsBending = on; });
    });
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.mesh || change.tissue) show();
    });
    show();
}

void BendingBox::show() {
    const Project& project = m_document.project();
    m_resists->setVisible(hasWall(*project.network) && !project.mesh->triangles.empty());
    m_resists->setChecked(project.base.resistsBending);
}

} // namespace esm
