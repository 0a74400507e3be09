#include "app/editor/panels/tissue/stiffening_row.h"

#include "widgets/inputs/quantity_formats.h"

namespace esm {

namespace {

/// Tissue gives way easily until its fibres are straight, about a fifth longer, and hardly beyond.
constexpr SpringStiffening proposedStiffening{0.2, 5};

NumberFormat strainFormat() {
    NumberFormat format = percentFormat(0.001, 10);
    format.step = 0.01;
    return format;
}

NumberFormat factorFormat() {
    NumberFormat format;
    format.unit = QStringLiteral("×");
    format.minimum = 0.01;
    format.maximum = 1000;
    return format;
}

} // namespace

StiffeningRow::StiffeningRow(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document),
      m_changes(new QCheckBox(tr("Stiffness changes when stretched"), this)), m_numbers(new ValueRows(this)),
      m_last(proposedStiffening) {
    setObjectName(QStringLiteral("stiffening"));
    m_changes->setObjectName(QStringLiteral("changesStiffness"));
    m_changes->setToolTip(
        tr("Springs of the whole organ, in every region, yield easily at first and resist "
           "more once they are stretched far, as tissue does when its fibres are straight"));
    m_strain = addNumber(tr("Beyond a stretch of"), strainFormat(), &SpringStiffening::strain,
                         tr("Set stretch before stiffness changes"));
    m_strain->setToolTip(tr("How much longer than at rest a spring becomes before it resists more"));
    m_factor = addNumber(tr("Stiffness is then"), factorFormat(), &SpringStiffening::factor,
                         tr("Set stiffness when stretched"));
    m_factor->setToolTip(tr("How many times harder tissue pulls back from there on; below 1, it gives way"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 6, 0, 0);
    column->setSpacing(6);
    column->addWidget(m_changes);
    column->addWidget(m_numbers);

    connect(m_changes, &QCheckBox::clicked, this, [this](bool on) {
        m_document.edit(
            on ? tr("Change stiffness when stretched") : tr("Keep stiffness when stretched"),
            [&](Project& project) { project.base.stiffening = on ? std::optional(m_last) : std::nullopt; });
    });
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.mesh) m_last = proposedStiffening;
        if (change.mesh || change.tissue) show();
    });
    show();
}

NumberField* StiffeningRow::addNumber(const QString& caption, const NumberFormat& format,
                                      double SpringStiffening::*part, const QString& edit) {
    auto* field = new NumberField(format, this);
    field->setAccessibleName(caption);
    m_numbers->addField(caption, field);
    connect(field, &NumberField::valueEdited, this, [this, part, edit](double value) {
        m_document.edit(
            edit,
            [&](Project& project) {
                if (project.base.stiffening) (*project.base.stiffening).*part = value;
            },
            MergeKey(EditKind::Stiffening, part == &SpringStiffening::strain ? 0 : 1));
    });
    connect(field, &NumberField::gestureFinished, &m_document, &Document::finishGesture);
    return field;
}

void StiffeningRow::show() {
    const std::optional<SpringStiffening>& stiffening = m_document.project().base.stiffening;
    if (stiffening) m_last = *stiffening;
    m_changes->setChecked(stiffening.has_value());
    m_numbers->setVisible(stiffening.has_value());
    m_strain->setValue(m_last.strain);
    m_factor->setValue(m_last.factor);
}

} // namespace esm
