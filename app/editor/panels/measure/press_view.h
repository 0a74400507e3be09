#pragma once

#include "app/editor/workers/virtual_test.h"
#include "widgets/inputs/elided_label.h"
#include "widgets/plot/curve_chart.h"

#include <QBoxLayout>
#include <QPushButton>

namespace esm {

/// Below the organ: the force on the finger over its depth, or what goes on in time, beside that of before.
class PressView : public QWidget {
    Q_OBJECT

public:
    PressView(Document& document, VirtualTest& test, QWidget* parent = nullptr);

    /// Narrower than all its buttons.
    QSize minimumSizeHint() const override { return {300, QWidget::minimumSizeHint().height()}; }

signals:
    void message(const QString& text);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void buildHeader();
    void showKind();
    void refresh();
    void exportTable();
    void exportChart();

    Document& m_document;
    VirtualTest& m_test;
    FingerTest m_shownKind = FingerTest::Press;
    VirtualTest::Press m_shown, m_shownBefore;
    QBoxLayout* m_header;
    ElidedLabel* m_title;
    QPushButton *m_keep, *m_clear, *m_exportTable, *m_exportChart;
    CurveChart* m_chart;
};

} // namespace esm
