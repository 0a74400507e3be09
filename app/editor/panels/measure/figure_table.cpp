#include "app/editor/panels/measure/figure_table.h"

#include "widgets/inputs/number_text.h"
#include "widgets/inputs/quiet_label.h"

#include <QVBoxLayout>

namespace esm {

namespace {

constexpr int shownDigits = 3;

QString shownFigure(std::optional<double> value) {
    return value ? numberText(*value, shownDigits) : QString(QChar(0x2013));
}

} // namespace

FigureTable::FigureTable(QWidget* parent) : QWidget(parent), m_grid(new QGridLayout) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(m_grid);
    column->addStretch();
    m_grid->setHorizontalSpacing(8);
    m_grid->setVerticalSpacing(6);
    m_grid->setColumnStretch(0, 1);
    m_grid->addWidget(quietLabel(tr("now"), this), 0, 1, Qt::AlignRight);
    m_grid->addWidget(quietLabel(tr("before"), this), 0, 2, Qt::AlignRight);
}

QLabel* FigureTable::addValue(int row, int column, const QString& name) {
    auto* value = new QLabel(this);
    value->setObjectName(name);
    value->setProperty(column == 1 ? "value" : "quiet", true);
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value->setMinimumWidth(value->fontMetrics().horizontalAdvance(QStringLiteral("−0.00524")));
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_grid->addWidget(value, row, column);
    return value;
}

void FigureTable::addRow(const QString& caption, const QString& name, const QString& explained) {
    const int row = m_grid->rowCount();
    QLabel* label = quietLabel(caption, this);
    label->setWordWrap(true);
    m_grid->addWidget(label, row, 0);
    m_rows.push_back({addValue(row, 1, name), addValue(row, 2, name + QStringLiteral("Before"))});
    for (QLabel* part : {label, m_rows.back().now, m_rows.back().before})
        part->setToolTip(explained);
    m_rows.back().now->setAccessibleName(caption);
    m_rows.back().before->setAccessibleName(tr("%1, before").arg(caption));
    setRow(m_rows.size() - 1, std::nullopt, std::nullopt);
}

void FigureTable::setRow(std::size_t row, std::optional<double> now, std::optional<double> before) {
    m_rows[row].now->setText(shownFigure(now));
    m_rows[row].before->setText(shownFigure(before));
}

} // namespace esm
