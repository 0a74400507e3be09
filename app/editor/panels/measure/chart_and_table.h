#pragma once

#include <QSplitter>
#include <QTabBar>

namespace esm {

/// A chart with its table beside it; where both have no room, either, by tabs.
class ChartAndTable : public QSplitter {
    Q_OBJECT

public:
    ChartAndTable(QWidget* chart, QWidget* table, QWidget* parent = nullptr);

    bool isNarrow() const { return m_isNarrow; }
    bool showsChart() const { return !m_isNarrow || m_tabs->currentIndex() == 0; }
    bool showsTable() const { return !m_isNarrow || m_tabs->currentIndex() == 1; }
    /// They choose what is shown; seen only where there is room for either alone.
    QTabBar* tabs() const { return m_tabs; }

signals:
    void arranged();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange();

    QWidget *m_chart, *m_table;
    QTabBar* m_tabs;
    bool m_isNarrow = false;
};

} // namespace esm
