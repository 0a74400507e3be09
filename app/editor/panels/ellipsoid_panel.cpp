#include "app/editor/panels/ellipsoid_panel.h"

#include "app/editor/commands/angles.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"
#include "widgets/inputs/quantity_formats.h"

namespace esm {

EllipsoidPanel::EllipsoidPanel(Document& document, Selection& selection, QWidget* parent)
    : Section(tr("Ellipsoid"), parent), m_document(document), m_selection(selection) {
    auto* rows = new ValueRows(this);
    m_centre = new VectorField(withoutUnit(lengthFormat(-1000)), this);
    m_radii = new VectorField(withoutUnit(lengthFormat(smallestLength)), this);
    m_turned = new VectorField(withoutUnit(angleFormat()), this);
    rows->addWideField(tr("Centre, mm"), m_centre);
    rows->addWideField(tr("Radii, mm"), m_radii);
    rows->addWideField(tr("Turned, °"), m_turned);
    m_nodesInside = rows->addText(tr("Inside"), QStringLiteral("nodesInside"));
    m_springsInside = rows->addText({}, QStringLiteral("springsInside"));
    m_centre->setObjectName(QStringLiteral("ellipsoidCentre"));
    m_radii->setObjectName(QStringLiteral("ellipsoidRadii"));
    body()->addWidget(rows);

    connect(m_centre, &VectorField::valueEdited, this, [this](const Eigen::Vector3d& centre) {
        edit(
            tr("Move region"), [&](Ellipsoid& ellipsoid) { ellipsoid.centre = centre; },
            QStringLiteral("ellipsoid centre"));
    });
    connect(m_radii, &VectorField::valueEdited, this, [this](const Eigen::Vector3d& radii) {
        edit(
            tr("Resize region"), [&](Ellipsoid& ellipsoid) { ellipsoid.radii = radii; },
            QStringLiteral("ellipsoid radii"));
    });
    connect(m_turned, &VectorField::valueEdited, this, [this](const Eigen::Vector3d& degrees) {
        edit(
            tr("Turn region"),
            [&](Ellipsoid& ellipsoid) { ellipsoid.orientation = Eigen::Quaterniond(rotationOf(degrees)); },
            QStringLiteral("ellipsoid turn"));
    });
    for (VectorField* field : {m_centre, m_radii, m_turned})
        connect(field, &VectorField::gestureFinished, &document, &Document::finishGesture);
    connect(&selection, &Selection::changed, this, &EllipsoidPanel::show);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.mesh || change.regions) show();
    });
    show();
}

void EllipsoidPanel::showEvent(QShowEvent* event) {
    Section::showEvent(event);
    showInside();
}

void EllipsoidPanel::show() {
    const Project& project = m_document.project();
    const auto selected = m_selection.region();
    const Ellipsoid* ellipsoid =
        selected && project.regions[*selected].ellipsoid ? &*project.regions[*selected].ellipsoid : nullptr;
    const QString none = tr("The whole organ has no ellipsoid: select or add a region");
    enable(m_centre, ellipsoid, tr("x, y, z"), none);
    enable(m_radii, ellipsoid, tr("Along the ellipsoid's own x, y, z"), none);
    enable(m_turned, ellipsoid, turnedToolTip(), none);
    using Vector = std::optional<Eigen::Vector3d>;
    m_centre->setValue(ellipsoid ? Vector(ellipsoid->centre) : Vector());
    m_radii->setValue(ellipsoid ? Vector(ellipsoid->radii) : Vector());
    m_turned->setValue(ellipsoid ? Vector(degreesOf(ellipsoid->orientation.toRotationMatrix())) : Vector());
    if (isVisible()) showInside();
}

void EllipsoidPanel::showInside() {
    const Project& project = m_document.project();
    const auto selected = m_selection.region();
    RegionCounts::Count inside{project.network->restPositions.size(), project.network->springs.size()};
    if (selected) inside = m_counts.of(project, *selected);
    m_nodesInside->setText(tr("%1 nodes").arg(countText(inside.nodes)));
    m_springsInside->setText(tr("%1 springs").arg(countText(inside.springs)));
}

void EllipsoidPanel::edit(const QString& text, const std::function<void(Ellipsoid&)>& change,
                          const QString& mergeKey) {
    const auto selected = m_selection.region();
    if (!selected || !m_document.project().regions[*selected].ellipsoid) return;
    m_document.edit(
        text, [&](Project& project) { change(*project.regions[*selected].ellipsoid); },
        QStringLiteral("%1 %2").arg(mergeKey).arg(*selected));
}

} // namespace esm
