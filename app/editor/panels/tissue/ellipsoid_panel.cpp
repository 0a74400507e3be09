#include "app/editor/panels/tissue/ellipsoid_panel.h"

#include "app/editor/edits/angles.h"
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
    m_rim = new NumberField(lengthFormat(0), this);
    rows->addField(tr("Soft rim"), m_rim);
    m_nodesInside = rows->addText(tr("Nodes inside"), QStringLiteral("nodesInside"));
    m_springsInside = rows->addText(tr("Springs inside"), QStringLiteral("springsInside"));
    m_rim->setObjectName(QStringLiteral("ellipsoidRim"));
    m_rim->setAccessibleName(tr("Soft rim"));
    m_rim->setToolTip(tr("How far outside the ellipsoid its tissue still blends into what lies around"));
    m_centre->setCaption(tr("Centre"));
    m_centre->setToolTip(tr("Where the middle of the ellipsoid lies"));
    m_radii->setCaption(tr("Radii"));
    m_radii->setToolTip(tr("From the middle of the ellipsoid to its surface, along each of its axes"));
    m_turned->setCaption(tr("Turned"));
    m_turned->setToolTip(tr("How far the ellipsoid is turned about x, y and z"));
    m_centre->setObjectName(QStringLiteral("ellipsoidCentre"));
    m_radii->setObjectName(QStringLiteral("ellipsoidRadii"));
    body()->addWidget(rows);

    connect(m_centre, &VectorField::valueEdited, this, [this](const Eigen::Vector3d& centre) {
        edit(
            tr("Move region"), [&](Ellipsoid& ellipsoid) { ellipsoid.centre = centre; },
            EditKind::EllipsoidCentre);
    });
    connect(m_radii, &VectorField::valueEdited, this, [this](const Eigen::Vector3d& radii) {
        edit(
            tr("Resize region"), [&](Ellipsoid& ellipsoid) { ellipsoid.radii = radii; },
            EditKind::EllipsoidRadii);
    });
    connect(m_turned, &VectorField::valueEdited, this, [this](const Eigen::Vector3d& degrees) {
        edit(
            tr("Turn region"),
            [&](Ellipsoid& ellipsoid) { ellipsoid.orientation = Eigen::Quaterniond(rotationOf(degrees)); },
            EditKind::EllipsoidTurn);
    });
    connect(m_rim, &NumberField::valueEdited, this, &EllipsoidPanel::editRim);
    connect(m_rim, &NumberField::gestureFinished, &document, &Document::finishGesture);
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
    const Region* selected = m_selection.selectedRegion();
    const Ellipsoid* ellipsoid = selected && selected->ellipsoid ? &*selected->ellipsoid : nullptr;
    const QString none = tr("The whole organ has no ellipsoid: select or add a region");
    enable(m_centre, ellipsoid, tr("x, y, z"), none);
    enable(m_radii, ellipsoid, tr("Along the ellipsoid's own x, y, z"), none);
    enable(m_turned, ellipsoid, turnedToolTip(), none);
    enable(
        m_rim, ellipsoid,
        tr("Around the ellipsoid its tissue fades over this width into what lies beneath; 0: a sharp border"),
        none);
    using Vector = std::optional<Eigen::Vector3d>;
    m_centre->setValue(ellipsoid ? Vector(ellipsoid->centre) : Vector());
    m_radii->setValue(ellipsoid ? Vector(ellipsoid->radii) : Vector());
    m_turned->setValue(ellipsoid ? Vector(degreesOf(ellipsoid->orientation.toRotationMatrix())) : Vector());
    m_rim->setValue(ellipsoid ? std::optional(selected->rim) : std::nullopt);
    if (isVisible()) showInside();
}

void EllipsoidPanel::showInside() {
    const Project& project = m_document.project();
    const Region* selected = m_selection.selectedRegion();
    RegionCount held;
    held.nodes = project.network->restPositions.size();
    held.springs = project.network->springs.size();
    if (selected) held = m_counts.of(project, *selected);
    const bool isSoft = selected && selected->rim > 0;
    const auto text = [&](std::size_t inside, std::size_t inRim) {
        return isSoft ? tr("%1, rim %2").arg(countText(inside), countText(inRim)) : countText(inside);
    };
    m_nodesInside->setText(text(held.nodes, held.rimNodes));
    m_springsInside->setText(text(held.springs, held.rimSprings));
}

void EllipsoidPanel::editRim(double metres) {
    const auto selected = m_selection.region();
    if (!selected) return;
    m_document.edit(tr("Soft rim"),
                    [&](Project& project) { partOf(project.regions, *selected).rim = metres; },
                    {EditKind::SoftRim, *selected});
}

void EllipsoidPanel::edit(const QString& text, const std::function<void(Ellipsoid&)>& change, EditKind kind) {
    const Region* selected = m_selection.selectedRegion();
    if (!selected || !selected->ellipsoid) return;
    const RegionId region = selected->id;
    m_document.edit(text, [&](Project& project) { change(*partOf(project.regions, region).ellipsoid); },
                    {kind, region});
}

} // namespace esm
