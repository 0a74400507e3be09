#pragma once

#include "app/editor/panels/measure/comparison_header.h"
#include "app/editor/workers/virtual_test.h"
#include "widgets/plot/curve_chart.h"

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

private:
    void tell(const QString& written);
    void showKind();
    void refresh();

    Document& m_document;
    VirtualTest& m_test;
    TestKind m_shownKind = TestKind::Press;
    VirtualTest::Press m_shown, m_shownBefore;
    ComparisonHeader* m_header;
    CurveChart* m_chart;
};

} // namespace esm
