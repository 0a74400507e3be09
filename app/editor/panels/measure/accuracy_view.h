#pragma once

#include "app/editor/dialogs/save_dialog.h"
#include "app/editor/panels/measure/chart_and_table.h"
#include "app/editor/panels/measure/runs_table.h"
#include "app/editor/panels/measure/speed_and_accuracy.h"
#include "widgets/inputs/elided_label.h"
#include "widgets/plot/accuracy_chart.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QPushButton>

namespace esm {

/// Below the organ: every run that was measured, as a point of a chart and as a row of a table. What is
/// marked in one is marked in the other; chosen in either, the tissue moves by it.
class AccuracyView : public QWidget {
    Q_OBJECT

public:
    AccuracyView(Document& document, SpeedAndAccuracy& accuracy, QWidget* parent = nullptr);

    /// Narrower than all its buttons, as low as they and a chart that can be read.
    QSize minimumSizeHint() const override { return {300, QWidget::minimumSizeHint().height()}; }

signals:
    void message(const QString& text);

private:
    void buildHeader();
    void refresh();
    void showRuns();
    void showUse();
    /// In chart and table alike.
    void mark(std::optional<std::size_t> run);
    bool isUsable(std::optional<std::size_t> run) const;
    void use(std::optional<std::size_t> run);
    void tell(const QString& written);
    void arrange();
    void exportTable();
    void exportChart();

    Document& m_document;
    SpeedAndAccuracy& m_accuracy;
    AccuracyChart* m_chart;
    RunsTable* m_table;
    ChartAndTable* m_both;
    QBoxLayout* m_header;
    ElidedLabel* m_title;
    QCheckBox* m_onlyUnbeaten;
    std::optional<std::size_t> m_marked; ///< run, or what was left out, by its row
    QPushButton *m_use, *m_exportTable, *m_exportChart;
};

} // namespace esm
