#pragma once

#include "app/editor/panels/measure/figure_table.h"
#include "app/editor/workers/poke_test.h"

#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QTimer>

namespace esm {

/// A poke by hand: recording it, giving it to the organ again, and what it came to in numbers.
class PokePanel : public QWidget {
    Q_OBJECT

public:
    explicit PokePanel(PokeTest& test, QWidget* parent = nullptr);

private:
    QWidget* buildRecording();
    QWidget* buildButtons();
    QWidget* buildNews();
    void refresh();
    void showFigures();
    void showNews();
    QString remark() const;

    PokeTest& m_test;
    QPushButton *m_record, *m_repeat, *m_cancel;
    QLabel* m_length;
    QStackedWidget* m_news; ///< what is said, or how far the work is
    QLabel* m_message;
    QProgressBar* m_progress;
    QTimer m_patience; ///< until work is long enough for a bar
    FigureTable* m_figures;
    PokeTest::Motion m_shown, m_shownBefore; ///< in the figures
};

} // namespace esm
