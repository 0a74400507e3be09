#include "app/editor/panels/tissue/clinical_rows.h"

#include "core/project/wall.h"
#include "widgets/inputs/elided_label.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/quantity_formats.h"

#include <QVBoxLayout>

namespace esm {

namespace {

NumberFormat thicknessFormat() {
    NumberFormat format = lengthFormat(smallestLength);
    format.maximum = 1;
    format.step = 0.0005;
    return format;
}

/// As the rows of other parameters are.
QWidget* row(const QString& caption, NumberField* field) {
    auto* name = new ElidedLabel;
    name->setText(caption);
    name->setProperty("strong", true);
    name->setBuddy(field);
    field->setAccessibleName(caption);
    field->setFixedWidth(field->widthFor(QStringLiteral("N·s/m"))); // the longest unit of tissue
    auto* both = new QWidget;
    auto* layout = new QHBoxLayout(both);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(name, 1);
    layout->addWidget(field);
    return both;
}

} // namespace

ClinicalRows::ClinicalRows(QWidget* parent)
    : QWidget(parent), m_modulus(new NumberField(modulusFormat(), this)),
      m_relaxation(new NumberField(timeFormat(), this)),
      m_thickness(new NumberField(thicknessFormat(), this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 4, 0, 0);
    column->setSpacing(6);
    column->addWidget(row(tr("Young's modulus"), m_modulus));
    column->addWidget(row(tr("relaxation time"), m_relaxation));
    m_wall = row(tr("thickness of the wall"), m_thickness);
    column->addWidget(m_wall);
    m_modulus->setObjectName(QStringLiteral("youngsModulus"));
    m_relaxation->setObjectName(QStringLiteral("relaxationTime"));
    m_thickness->setObjectName(QStringLiteral("wallThickness"));
    m_modulus->setToolTip(
        tr("How firm the tissue is, as elastography measures it; the spring constant follows. "
           "Springs alone have Poisson's ratio 1/3 in a surface and 1/4 in a solid"));
    m_thickness->setToolTip(
        tr("Of the organ's wall: a spring constant of a wall twice as thick means half the "
           "modulus. A solid organ's springs speak of such a wall too"));
    m_modulus->setEmptyText(tr("as beneath"));
    connect(m_modulus, &NumberField::valueEdited, this, &ClinicalRows::youngsModulusEdited);
    connect(m_relaxation, &NumberField::valueEdited, this, &ClinicalRows::relaxationTimeEdited);
    connect(m_thickness, &NumberField::valueEdited, this, &ClinicalRows::wallThicknessEdited);
    for (const NumberField* field : {m_modulus, m_relaxation, m_thickness})
        connect(field, &NumberField::gestureFinished, this, &ClinicalRows::gestureFinished);
}

void ClinicalRows::setTissue(const Tissue& tissue) {
    const auto& [springConstant, relaxationTime, wallThickness] = tissue;
    m_thickness->setValue(wallThickness);
    m_modulus->setValue(springConstant ? std::optional(youngsModulusOfWall(*springConstant, wallThickness))
                                       : std::nullopt);
    const bool draws = springConstant && *springConstant > 0;
    m_relaxation->setEmptyText(springConstant && !draws ? QString(QChar(0x2013)) : tr("as beneath"));
    m_relaxation->setValue(relaxationTime);
    enable(m_relaxation, draws,
           tr("Viscosity over spring constant: stretched tissue that is let go has a third of its way left "
              "after this time; the viscosity follows. A dent takes some twenty times as long in a solid "
              "organ, and a hundred times and more in a hollow one that it bends and hardly stretches"),
           tr("There is no relaxation time where no spring constant is set that draws the tissue back"));
}

void ClinicalRows::showWallThickness(bool isShown) {
    m_wall->setVisible(isShown);
}

} // namespace esm
