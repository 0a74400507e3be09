#include "app/editor/panels/organ/bending_row.h"

#include "widgets/inputs/quantity_formats.h"

namespace esm {

BendingRow::BendingRow(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_resists(new QCheckBox(tr("Wall resists bending"), this)),
      m_numbers(new ValueRows(this)), m_thickness(new NumberField(lengthFormat(1e-4), this)),
      m_last(wallThickness) {
    setObjectName(QStringLiteral("bending"));
    m_resists->setObjectName(QStringLiteral("resistsBending"));
    m_resists->setToolTip(tr("A flap or a tube keeps its form, as a wall of that thickness does; without, "
                             "the surface bends freely like a cloth"));
    m_thickness->setAccessibleName(tr("Wall thickness"));
    m_thickness->setToolTip(tr("Twice as thick a wall resists bending four times as much"));
    m_numbers->addField(tr("Wall thickness"), m_thickness);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 6, 0, 0);
    column->setSpacing(6);
    column->addWidget(m_resists);
    column->addWidget(m_numbers);

    connect(m_resists, &QCheckBox::clicked, this, [this](bool on) {
        m_document.edit(on ? tr("Resist bending") : tr("Bend freely"), [&](Project& project) {
            project.base.bendingThickness = on ? std::optional(m_last) : std::nullopt;
        });
    });
    connect(m_thickness, &NumberField::valueEdited, this, [this](double thickness) {
        m_document.edit(
            tr("Set wall thickness"),
            [thickness](Project& project) { project.base.bendingThickness = thickness; },
            MergeKey(EditKind::WallThickness));
    });
    connect(m_thickness, &NumberField::gestureFinished, &document, &Document::finishGesture);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.mesh) m_last = wallThickness;
        if (change.mesh || change.tissue) show();
    });
    show();
}

void BendingRow::show() {
    const Project& project = m_document.project();
    const std::optional<double>& thickness = project.base.bendingThickness;
    if (thickness) m_last = *thickness;
    setVisible(hasWall(*project.network));
    m_resists->setChecked(thickness.has_value());
    m_numbers->setVisible(thickness.has_value());
    m_thickness->setValue(m_last);
}

} // namespace esm
