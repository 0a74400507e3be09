#pragma once

#include "app/editor/panels/measure/figure_table.h"
#include "app/editor/panels/measure/work_news.h"
#include "app/editor/workers/poke_test.h"

#include <QPushButton>

namespace esm {

/// A poke by hand: recording it, giving it to the organ again, and what it came to in numbers.
class PokePanel : public QWidget {
    Q_OBJECT

public:
    explicit PokePanel(PokeTest& test, QWidget* parent = nullptr);

signals:
    /// The pull is to be the project's scene.
    void sceneAsked();

private:
    QWidget* buildRecording();
    QWidget* buildButtons();
    void refresh();
    void enableMakingScene();
    void showFigures();
    void showMoment();
    void showNews();
    QString remark() const;

    PokeTest& m_test;
    QPushButton *m_record, *m_repeat, *m_cancel, *m_makeScene;
    QLabel* m_length;
    WorkNews* m_news;
    FigureTable* m_figures;
    PokeTest::Motion m_shown, m_shownBefore; ///< in the figures
};

} // namespace esm
