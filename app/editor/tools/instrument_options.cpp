#include "app/editor/tools/instrument_options.h"

#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/quantity_formats.h"
#include "widgets/inputs/spoken.h"

#include <QHBoxLayout>
#include <QLabel>

namespace esm {

namespace {

// Pixels; so much has room beside undo and redo in the smallest window.
constexpr int kindWidth = 70, fieldWidth = 84, gap = 6;

} // namespace

InstrumentOptions::InstrumentOptions(InstrumentTool& tool, QWidget* parent)
    : QWidget(parent), m_tool(tool), m_kind(new QComboBox(this)),
      m_radius(new NumberField(lengthFormat(smallestLength), this)),
      m_length(new NumberField(lengthFormat(smallestLength), this)) {
    m_kind->addItem(tr("ball"), static_cast<int>(InstrumentKind::Ball));
    m_kind->addItem(tr("shaft"), static_cast<int>(InstrumentKind::Shaft));
    m_kind->setObjectName(QStringLiteral("instrumentKind"));
    m_kind->setFixedWidth(kindWidth);
    nameChoice(*m_kind, tr("Instrument"));
    m_kind->setToolTip(
        tr("What pushes the tissue: a ball, or a shaft as of laparoscopic instruments, round at both ends"));
    guardFromWheel(*m_kind);
    m_radius->setObjectName(QStringLiteral("instrumentRadius"));
    m_length->setObjectName(QStringLiteral("instrumentLength"));
    auto* row = new QHBoxLayout(this);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
    row->setContentsMargins(10, 0, 0, 0);
    row->setSpacing(gap);
    row->addWidget(m_kind);
    addField(*row, tr("Radius"), m_radius, tr("Radius of the ball, or of the shaft and its ends"));
    m_lengthCaption = addField(*row, tr("Length"), m_length,
                               tr("Length of the shaft between the centres of its round ends"));
    connectFields();
    show();
}

QLabel* InstrumentOptions::addField(QHBoxLayout& row, const QString& caption, QWidget* field,
                                    const QString& toolTip) {
    auto* label = new QLabel(caption, this);
    label->setProperty("quiet", true);
    label->setBuddy(field);
    field->setFixedWidth(fieldWidth);
    field->setAccessibleName(caption);
    for (QWidget* widget : std::initializer_list<QWidget*>{label, field}) {
        widget->setToolTip(toolTip);
        row.addWidget(widget);
    }
    return label;
}

void InstrumentOptions::connectFields() {
    connect(m_kind, qOverload<int>(&QComboBox::activated), this,
            [this] { m_tool.chooseKind(static_cast<InstrumentKind>(m_kind->currentData().toInt())); });
    connect(m_radius, &NumberField::valueEdited, &m_tool, &InstrumentTool::chooseRadius);
    connect(m_length, &NumberField::valueEdited, &m_tool, &InstrumentTool::chooseLength);
    connect(&m_tool, &InstrumentTool::shapeChanged, this, &InstrumentOptions::show);
}

void InstrumentOptions::show() {
    const bool isShaft = std::holds_alternative<Capsule>(m_tool.shape());
    m_kind->setCurrentIndex(isShaft ? 1 : 0);
    m_radius->setValue(radiusOf(m_tool.shape()));
    m_lengthCaption->setVisible(isShaft);
    m_length->setVisible(isShaft);
    if (isShaft) m_length->setValue(lengthOf(m_tool.shape()));
}

} // namespace esm
