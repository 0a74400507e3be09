#pragma once

#include "app/editor/workers/poke_test.h"
#include "widgets/inputs/elided_label.h"
#include "widgets/inputs/value_slider.h"
#include "widgets/plot/curve_chart.h"

#include <QBoxLayout>
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

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void buildHeader();
    QLayout* buildPlayer();
    void refresh();
    void showMotions();
    void showMoment();
    void exportTable();
    void exportChart();

    Document& m_document;
    PokeTest& m_test;
    PokeTest::Motion m_shown, m_shownBefore;
    QBoxLayout* m_header;
    ElidedLabel* m_title;
    QPushButton *m_keep, *m_clear, *m_table, *m_picture, *m_film, *m_watch, *m_leave;
    ValueSlider* m_moment; ///< in pictures
    QLabel* m_time;
    CurveChart* m_chart;
};

} // namespace esm
