#include "app/editor/panels/fuzzy/range_row.h"

#include "widgets/fuzzy/partition_picture.h"

#include <QHBoxLayout>
#include <QLabel>

namespace esm {

namespace {

QLabel* rangeCaption(const QString& text, QWidget* buddy) {
    auto* label = new QLabel(text, buddy->parentWidget());
    label->setProperty("quiet", true);
    label->setBuddy(buddy);
    return label;
}

} // namespace

RangeRow::RangeRow(QWidget* parent)
    : QWidget(parent), m_minimum(new NumberField({}, this)), m_maximum(new NumberField({}, this)),
      m_unit(new QLineEdit(this)), m_stretches(new QCheckBox(tr("terms stretch with the range"), this)) {
    m_minimum->setAccessibleName(tr("Range from"));
    m_maximum->setAccessibleName(tr("Range to"));
    m_unit->setAccessibleName(tr("Unit"));
    m_unit->setToolTip(tr("The unit of its values, for people; may be empty"));
    m_unit->setPlaceholderText(tr("none"));
    m_unit->setMaxLength(20);
    m_unit->setObjectName(QStringLiteral("variableUnit"));
    m_stretches->setObjectName(QStringLiteral("termsStretch"));
    m_stretches->setToolTip(
        tr("On: every term keeps its share of the range, as when the unit changes. Off: terms "
           "stay where they are, those at an end reach on to the new end."));
    for (QLineEdit* field :
         {static_cast<QLineEdit*>(m_minimum), static_cast<QLineEdit*>(m_maximum), m_unit}) {
        field->setMinimumWidth(50);
        field->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    }
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(rangeCaption(tr("Range"), m_minimum));
    row->addWidget(m_minimum, 3);
    row->addWidget(rangeCaption(tr("to"), m_maximum));
    row->addWidget(m_maximum, 3);
    row->addWidget(rangeCaption(tr("Unit"), m_unit));
    row->addWidget(m_unit, 3);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addLayout(row);
    column->addWidget(m_stretches);

    connect(m_minimum, &NumberField::valueEdited, this,
            [this](double value) { announceRange(value, m_maximum->value().value_or(value)); });
    connect(m_maximum, &NumberField::valueEdited, this,
            [this](double value) { announceRange(m_minimum->value().value_or(value), value); });
    for (const NumberField* field : {m_minimum, m_maximum})
        connect(field, &NumberField::gestureFinished, this, &RangeRow::gestureFinished);
    connect(m_unit, &QLineEdit::editingFinished, this, [this] {
        if (!m_unit->isModified()) return;
        m_unit->setModified(false);
        emit unitEdited(m_unit->text().trimmed().toStdString());
    });
}

void RangeRow::setVariable(const FuzzyVariable& variable) {
    NumberFormat below, above;
    below.step = above.step = 10 * cornerStep(variable);
    below.unit = above.unit = QString::fromStdString(variable.unit);
    below.showsUnit = above.showsUnit = false; // it stands beside them
    below.maximum = variable.maximum;
    above.minimum = variable.minimum;
    m_minimum->setFormat(below);
    m_maximum->setFormat(above);
    const QString in = variable.unit.empty() ? QString() : tr(", in %1").arg(below.unit);
    m_minimum->setToolTip(tr("The least value of the variable%1").arg(in));
    m_maximum->setToolTip(tr("The greatest value of the variable%1").arg(in));
    m_minimum->setValue(variable.minimum);
    m_maximum->setValue(variable.maximum);
    if (!(m_unit->hasFocus() && m_unit->isModified())) m_unit->setText(QString::fromStdString(variable.unit));
}

void RangeRow::announceRange(double minimum, double maximum) {
    emit rangeEdited(minimum, maximum, m_stretches->isChecked() ? TermsInRange::Stretch : TermsInRange::Stay);
}

} // namespace esm
