#include "app/editor/panels/parameter_row.h"

#include "widgets/fuzzy/small_font.h"
#include "widgets/inputs/elided_label.h"
#include "widgets/inputs/quantity_formats.h"

#include <QVBoxLayout>

#include <algorithm>

namespace esm {

NumberFormat parameterFormat(Parameter parameter) {
    if (parameter == Parameter::Mass) return massFormat();
    NumberFormat format;
    format.unit = parameter == Parameter::SpringConstant ? QStringLiteral("N/m") : QStringLiteral("N·s/m");
    format.minimum = 0;
    format.maximum = 1e9;
    return format;
}

ParameterRow::ParameterRow(Parameter parameter, Extent extent, QWidget* parent)
    : QWidget(parent), m_field(new NumberField(parameterFormat(parameter), this)) {
    const QString caption = parameterName(parameter, extent);
    auto* name = new ElidedLabel(this);
    name->setText(caption);
    name->setProperty("strong", true);
    name->setBuddy(m_field);
    m_field->setAccessibleName(caption);
    m_field->setToolTip(tr("%1 as a number. Up and Down step it").arg(caption));
    m_field->setFixedWidth(m_field->widthFor(QStringLiteral("N·s/m"))); // the longest unit of tissue
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(3);
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    column->addLayout(row);
    row->addWidget(name, 1);
    connect(m_field, &NumberField::valueEdited, this, &ParameterRow::valueEdited);
    connect(m_field, &NumberField::gestureFinished, this, &ParameterRow::gestureFinished);
    if (extent == Extent::Region) {
        m_field->setEmptyText(tr("as beneath"));
        m_hold = new QToolButton(this);
        m_hold->setText(tr("hold"));
        m_hold->setAccessibleName(tr("hold %1").arg(caption));
        m_hold->setCheckable(true);
        m_hold->setObjectName(QStringLiteral("holdButton"));
        row->addWidget(m_hold);
        m_remark = new QLabel(this);
        m_remark->setObjectName(QStringLiteral("beneath"));
        m_remark->setProperty("quiet", true);
        m_remark->setFont(smallFont(font()));
        column->addWidget(m_remark);
        connect(m_hold, &QToolButton::clicked, this, [this](bool held) {
            if (!held) return emit released();
            if (m_field->value()) return emit valueEdited(*m_field->value());
            // Nothing to hold yet: the number is asked for.
            m_hold->setChecked(false);
            m_field->setFocus();
        });
    }
    row->addWidget(m_field);
}

void ParameterRow::setValue(std::optional<double> value, Manner manner) {
    m_field->setValue(value);
    if (!m_hold) return;
    const bool isHeld = manner == Manner::Held;
    m_hold->setChecked(isHeld);
    m_hold->setToolTip(isHeld  ? tr("Let this value go again")
                       : value ? tr("Hold this value, whatever the fuzzy system says")
                               : tr("Type a value to hold it"));
}

void ParameterRow::setRemark(const QString& remark) {
    if (m_remark) m_remark->setText(remark);
}

} // namespace esm
