#include "app/editor/tools/distance_panel.h"

#include "app/editor/tools/distance_tool.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"
#include "widgets/inputs/quantity_formats.h"

namespace esm {

namespace {

/// Small organs are measured to the hundredth of a millimetre.
NumberFormat measureFormat() {
    NumberFormat format = lengthFormat(smallestLength);
    format.decimals = -1;
    return format;
}

} // namespace

DistancePanel::DistancePanel(DistanceTool& tool, QWidget* parent)
    : Section(tr("Distance"), parent), m_tool(tool), m_trueLength(new NumberField(measureFormat(), this)),
      m_kept(new QComboBox(this)), m_scale(new QPushButton(tr("Scale organ"), this)),
      m_remark(new QLabel(this)) {
    layOut();
    connect(m_trueLength, &NumberField::valueEdited, &tool, &DistanceTool::setTrueLength);
    connect(m_trueLength, &NumberField::refusalChanged, this, &DistancePanel::showScaling);
    connect(m_kept, qOverload<int>(&QComboBox::activated), this,
            [this] { m_tool.setKept(static_cast<KeptByScaling>(m_kept->currentData().toInt())); });
    connect(m_scale, &QPushButton::clicked, &tool, &DistanceTool::scaleOrgan);
    connect(&tool, &DistanceTool::changed, this, &DistancePanel::show);
    show();
}

void DistancePanel::layOut() {
    auto* rows = new ValueRows(this);
    m_measured = rows->addText(tr("Measured at rest"), QStringLiteral("measuredLength"));
    rows->addField(tr("True length"), m_trueLength);
    rows->addWideField(tr("When the organ is scaled"), m_kept);
    m_kept->addItem(tr("keep mass, N/m and N·s/m"), static_cast<int>(KeptByScaling::Mass));
    m_kept->addItem(tr("keep density"), static_cast<int>(KeptByScaling::Density));
    m_kept->setToolTip(tr("Density: masses grow with the volume, but for those that a fuzzy system infers; "
                          "N/m and N·s/m stay"));
    m_trueLength->setToolTip(
        tr("How long the distance truly is, as it was measured on a patient or a print"));
    m_trueLength->setObjectName(QStringLiteral("trueLength"));
    m_kept->setObjectName(QStringLiteral("keptByScaling"));
    m_scale->setObjectName(QStringLiteral("scaleOrgan"));
    m_scale->setFocusPolicy(Qt::TabFocus);
    m_remark->setObjectName(QStringLiteral("scaleRemark"));
    m_remark->setProperty("quiet", true);
    m_remark->setWordWrap(true);
    m_remark->setAlignment(Qt::AlignTop);
    m_remark->setMinimumHeight(2 * m_remark->fontMetrics().lineSpacing());
    guardFromWheel(*m_kept);
    body()->addWidget(rows);
    body()->addWidget(m_scale);
    body()->addWidget(m_remark);
}

void DistancePanel::show() {
    const auto length = m_tool.length();
    m_measured->setText(length ? withUnit(1000 * *length, QStringLiteral("mm")) : QString(QChar(0x2013)));
    m_trueLength->setValue(m_tool.trueLength());
    m_kept->setCurrentIndex(m_kept->findData(static_cast<int>(m_tool.kept())));
    showScaling();
}

/// What was typed and not taken comes first: the length of before it is not what is seen.
void DistancePanel::showScaling() {
    const QString refusal = m_trueLength->refusal();
    const QString obstacle = refusal.isEmpty() ? m_tool.obstacle() : refusal;
    enable(m_scale, obstacle.isEmpty(),
           tr("Make the organ, and all that lies on it, as large as the true length says"), obstacle);
    m_remark->setText(obstacle);
}

} // namespace esm
