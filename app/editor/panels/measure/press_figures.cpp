#include "app/editor/panels/measure/press_figures.h"

#include "widgets/inputs/number_text.h"
#include "widgets/inputs/quiet_label.h"

#include <QVariant>

namespace esm {

namespace {

constexpr int figureDigits = 3;

QString figureText(const MeasuredPress* press, std::optional<double> (*value)(const MeasuredPress&)) {
    const std::optional<double> number = press ? value(*press) : std::nullopt;
    return number ? numberText(*number, figureDigits) : QString(QChar(0x2013));
}

} // namespace

PressFigures::PressFigures(const std::vector<PressFigure>& figures, QWidget* parent)
    : QWidget(parent), m_grid(new QGridLayout(this)) {
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(8);
    m_grid->setVerticalSpacing(6);
    m_grid->setColumnStretch(0, 1);
    m_grid->addWidget(quietLabel(tr("now"), this), 0, 1, Qt::AlignRight);
    m_grid->addWidget(quietLabel(tr("before"), this), 0, 2, Qt::AlignRight);
    for (const PressFigure& figure : figures)
        addRow(figure);
    m_grid->setRowStretch(m_grid->rowCount(), 1);
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

void PressFigures::addRow(const PressFigure& figure) {
    const auto& [caption, name, explained, value] = figure;
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

void PressFigures::setResults(const MeasuredPress* now, const MeasuredPress* before) {
    for (const Row& row : m_rows) {
        row.now->setText(figureText(now, row.value));
        row.before->setText(figureText(before, row.value));
    }
}

} // namespace esm
