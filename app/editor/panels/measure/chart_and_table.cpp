#include "app/editor/panels/measure/chart_and_table.h"

#include "widgets/inputs/control_keys.h"

namespace esm {

namespace {

constexpr int chartWidth = 360, tableWidth = 570;        // pixels, in proportion
constexpr int leastWidthOfBoth = 720, leastHeight = 150; // pixels

} // namespace

ChartAndTable::ChartAndTable(QWidget* chart, QWidget* table, QWidget* parent)
    : QSplitter(Qt::Horizontal, parent), m_chart(chart), m_table(table),
      m_tabs(new QTabBar(parent)) { // its own child would be a part of the splitter
    setChildrenCollapsible(false);
    setHandleWidth(9);
    setMinimumHeight(leastHeight);
    addWidget(chart);
    addWidget(table);
    setStretchFactor(0, 1);
    setStretchFactor(1, 1);
    m_tabs->setObjectName(QStringLiteral("measureTabs"));
    m_tabs->setAccessibleName(tr("Views of what was measured"));
    m_tabs->setDrawBase(false);
    m_tabs->setExpanding(false);
    guardFromWheel(*m_tabs, Turning::Never);
    m_tabs->setFocusPolicy(Qt::TabFocus);
    m_tabs->setTabToolTip(m_tabs->addTab(tr("Chart")), tr("Error over speed of every run"));
    m_tabs->setTabToolTip(m_tabs->addTab(tr("Table")), tr("Every run in a row"));
    connect(m_tabs, &QTabBar::currentChanged, this, &ChartAndTable::arrange);
    arrange();
}

void ChartAndTable::resizeEvent(QResizeEvent* event) {
    QSplitter::resizeEvent(event);
    const bool isNarrow = width() < leastWidthOfBoth;
    if (isNarrow == m_isNarrow) return;
    m_isNarrow = isNarrow;
    arrange();
}

void ChartAndTable::arrange() {
    m_tabs->setVisible(m_isNarrow);
    m_chart->setVisible(showsChart());
    m_table->setVisible(showsTable());
    if (!m_isNarrow) setSizes({chartWidth, tableWidth}); // one that was hidden has lost its share
    emit arranged();
}

} // namespace esm
