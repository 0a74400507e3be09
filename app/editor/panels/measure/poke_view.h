#pragma once

#include "app/editor/panels/measure/comparison_header.h"
#include "app/editor/workers/poke_test.h"
#include "widgets/inputs/value_slider.h"
#include "widgets/plot/curve_chart.h"

#include <QLabel>
#include <QPushButton>

namespace esm {

/// Below the organ: the moment that is shown, and the force over time beside that of before.
class PokeView : public QWidget {
    Q_OBJECT

public:
    PokeView(Document& document, PokeTest& test, QWidget* parent = nullptr);

    /// Narrower than all its buttons.
    QSize minimumSizeHint() const override { return {300, QWidget::minimumSizeHint().height()}; }

signals:
    void message(const QString& text);
    /// The motion is to be written as a film.
    void filmAsked();

private:
    void connectHeader();
    void tell(const QString& written);
    QLayout* buildPlayer();
    void refresh();
    void showMotions();
    void showMoment();

    Document& m_document;
    PokeTest& m_test;
    PokeTest::Motion m_shown, m_shownBefore;
    ComparisonHeader* m_header;
    QPushButton *m_film, *m_watch, *m_leave;
    ValueSlider* m_moment; ///< in pictures
    QLabel* m_time;
    CurveChart* m_chart;
};

} // namespace esm
