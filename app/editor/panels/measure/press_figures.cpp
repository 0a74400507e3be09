#include "app/editor/panels/measure/press_figures.h"

#include "widgets/inputs/number_text.h"
#include "widgets/inputs/quiet_label.h"

#include <QVariant>

namespace esm {

namespace {

constexpr int figureDigits = 3;

QString figureText(const ProbeResult* result, double (*value)(const ProbeResult&)) {
    return result ? numberText(value(*result), figureDigits) : QString(QChar(0x2013));
}

} // namespace

PressFigures::PressFigures(QWidget* parent) : QWidget(parent), m_grid(new QGridLayout(this)) {
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(8);
    m_grid->setVerticalSpacing(6);
    m_grid->setColumnStretch(0, 1);
    m_grid->addWidget(quietLabel(tr("now"), this), 0, 1, Qt::AlignRight);
    m_grid->addWidget(quietLabel(tr("before"), this), 0, 2, Qt::AlignRight);
    addRow(tr("Depth, mm"), QStringLiteral("pressDepth"), tr("How deep the finger came, from first touch"),
           [](const ProbeResult& result) { return 1000 * result.curve.back().depth; });
    addRow(tr("Force, N"), QStringLiteral("pressForce"), tr("With which the organ resists at that depth"),
           [](const ProbeResult& result) { return result.curve.back().force; });
    addRow(tr("Stiffness at the start, N/mm"), QStringLiteral("stiffnessAtStart"),
           tr("How steeply the force rises at the start"),
           [](const ProbeResult& result) { return result.stiffnessAtStart / 1000; });
    addRow(tr("Stiffness at the end, N/mm"), QStringLiteral("stiffnessAtEnd"),
           tr("How steeply the force rises at the full depth"),
           [](const ProbeResult& result) { return result.stiffness / 1000; });
    addRow(tr("Modulus of an even solid, kPa"), QStringLiteral("equivalentModulus"),
           tr("Young's modulus of one that is wide and deep beside the finger and would resist as much. Of a "
              "hollow organ it says how firm it feels, not how firm its wall is"),
           [](const ProbeResult& result) { return result.youngsModulus / 1000; });
    setResults(nullptr, nullptr);
}

QLabel* PressFigures::addValue(int row, int column, const QString& name) {
    auto* value = new QLabel(this);
    value->setObjectName(name);
    value->setProperty(column == 1 ? "value" : "quiet", true);
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value->setMinimumWidth(value->fontMetrics().horizontalAdvance(QStringLiteral("−0.00524")));
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_grid->addWidget(value, row, column);
    return value;
}

void PressFigures::addRow(const QString& caption, const QString& name, const QString& explained,
                          double (*value)(const ProbeResult&)) {
    const int row = m_grid->rowCount();
    QLabel* label = quietLabel(caption, this);
    label->setWordWrap(true);
    m_grid->addWidget(label, row, 0);
    m_rows.push_back({value, addValue(row, 1, name), addValue(row, 2, name + QStringLiteral("Before"))});
    for (QLabel* part : {label, m_rows.back().now, m_rows.back().before})
        part->setToolTip(explained);
    m_rows.back().now->setAccessibleName(caption);
    m_rows.back().before->setAccessibleName(tr("%1, before").arg(caption));
}

void PressFigures::setResults(const ProbeResult* now, const ProbeResult* before) {
    for (const Row& row : m_rows) {
        row.now->setText(figureText(now, row.value));
        row.before->setText(figureText(before, row.value));
    }
}

} // namespace esm
