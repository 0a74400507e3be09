#pragma once

#include "app/editor/panels/measure/accuracy_panel.h"
#include "app/editor/panels/measure/poke_panel.h"
#include "app/editor/panels/measure/virtual_test_panel.h"

#include <QTabBar>

namespace esm {

/// What can be measured: one page of it at a time.
enum class MeasurePage { Accuracy, VirtualTest, Poke };

/// The left column of the workspace Measure: a tab for each page, and the panels of the one that is chosen.
class MeasureColumn : public QWidget {
    Q_OBJECT

public:
    MeasureColumn(Document& document, SpeedAndAccuracy& accuracy, VirtualTest& test, PokeTest& poke,
                  QWidget* parent = nullptr);

    MeasurePage page() const { return static_cast<MeasurePage>(m_tabs->currentIndex()); }
    void choose(MeasurePage page) { m_tabs->setCurrentIndex(static_cast<int>(page)); }
    VirtualTestPanel& testPanel() { return *m_test; }
    PokePanel& pokePanel() { return *m_poke; }

signals:
    void chosen(esm::MeasurePage page);

private:
    void show(MeasurePage page);

    QTabBar* m_tabs;
    AccuracyPanel* m_accuracy;
    VirtualTestPanel* m_test;
    PokePanel* m_poke;
};

} // namespace esm
