#include "app/editor/panels/ellipsoid_panel.h"

#include "app/editor/commands/angles.h"
#include "widgets/inputs/number_text.h"

namespace esm {

namespace {

NumberFormat lengthFormat(double minimum) {
    NumberFormat format;
    format.shownPerValue = 1000;
    format.decimals = 1;
    format.minimum = minimum;
    format.maximum = 1000;
    format.step = 0.001;
    return format;
}

NumberFormat angleFormat() {
    NumberFormat format;
    format.decimals = 0;
    format.minimum = -360;
    format.maximum = 360;
    format.step = 1;
    return format;
}

} // namespace

EllipsoidPanel::EllipsoidPanel(Document& document, Selection& selection, QWidget* parent)
    : Section(tr("Ellipsoid"), parent), m_document(document), m_selection(selection) {
    auto* rows = new ValueRows(this);
    m_centre = new VectorField(lengthFormat(-1000), this);
    m_radii = new VectorField(lengthFormat(1e-5), this);
    m_turned = new VectorField(angleFormat(), this);
    rows->addField(tr("Centre, mm"), m_centre);
    rows->addField(tr("Radii, mm"), m_radii);
    rows->addField(tr("Turned, °"), m_turned);
    m_inside = rows->addText(tr("Inside"), QStringLiteral("ellipsoidInside"));
    m_centre->setObjectName(QStringLiteral("ellipsoidCentre"));
    m_radii->setObjectName(QStringLiteral("ellipsoidRadii"));
    body()->addWidget(rows);

    connect(m_centre, &VectorField::valueEdited, this, [this](const Eigen::Vector3d& centre) {
        edit(tr("Move region"), [&](Ellipsoid& ellipsoid) { ellipsoid.centre = centre; });
    });
    connect(m_radii, &VectorField::valueEdited, this, [this](const Eigen::Vector3d& radii) {
        edit(tr("Resize region"), [&](Ellipsoid& ellipsoid) { ellipsoid.radii = radii; });
    });
    connect(m_turned, &VectorField::valueEdited, this, [this](const Eigen::Vector3d& degrees) {
        edit(tr("Turn region"),
             [&](Ellipsoid& ellipsoid) { ellipsoid.orientation = Eigen::Quaterniond(rotationOf(degrees)); });
    });
    connect(&selection, &Selection::changed, this, &EllipsoidPanel::show);
    connect(&document, &Document::changed, this, &EllipsoidPanel::show);
    show();
}

void EllipsoidPanel::show() {
    const Project& project = m_document.project();
    const auto selected = m_selection.region();
    const Ellipsoid* ellipsoid =
        selected && project.regions[*selected].ellipsoid ? &*project.regions[*selected].ellipsoid : nullptr;
    for (QWidget* field : {m_centre, m_radii, m_turned}) {
        field->setEnabled(ellipsoid);
        field->setToolTip(ellipsoid ? tr("x, y, z")
                                    : tr("The whole organ has no ellipsoid: select or add a region"));
    }
    if (!ellipsoid) {
        for (VectorField* field : {m_centre, m_radii, m_turned})
            field->setValue(std::nullopt);
        m_inside->setText(tr("all nodes"));
        return;
    }
    m_centre->setValue(ellipsoid->centre);
    m_radii->setValue(ellipsoid->radii);
    m_turned->setValue(degreesOf(ellipsoid->orientation.toRotationMatrix()));
    const RegionResult result = evaluateRegion(project, project.regions[*selected]);
    m_inside->setText(tr("%1 nodes, %2 springs").arg(countText(result.nodes), countText(result.springs)));
    m_inside->setToolTip(m_inside->text());
}

void EllipsoidPanel::edit(const QString& text, const std::function<void(Ellipsoid&)>& change) {
    const auto selected = m_selection.region();
    if (!selected || !m_document.project().regions[*selected].ellipsoid) return;
    m_document.edit(text, [&](Project& project) { change(*project.regions[*selected].ellipsoid); });
}

} // namespace esm
