#include "app/editor/panels/measure/measure_column.h"

#include "widgets/inputs/control_keys.h"

namespace esm {

MeasureColumn::MeasureColumn(Document& document, SpeedAndAccuracy& accuracy, VirtualTest& test,
                             PokeTest& poke, QWidget* parent)
    : QWidget(parent), m_tabs(new QTabBar(this)), m_accuracy(new AccuracyPanel(document, accuracy, this)),
      m_test(new VirtualTestPanel(document, test, this)), m_poke(new PokePanel(poke, this)) {
    m_tabs->setObjectName(QStringLiteral("measurePages"));
    m_tabs->setAccessibleName(tr("What is measured"));
    m_tabs->setDrawBase(false);
    m_tabs->setExpanding(false);
    m_tabs->setFocusPolicy(Qt::TabFocus);
    guardFromWheel(*m_tabs, Turning::Never);
    m_tabs->setTabToolTip(m_tabs->addTab(tr("Speed")),
                          tr("How fast and how exactly this machine computes the motion"));
    m_tabs->setTabToolTip(m_tabs->addTab(tr("Virtual test")), tr("How the organ resists a finger"));
    m_tabs->setTabToolTip(m_tabs->addTab(tr("Poke")),
                          tr("How the organ moves under what your hand did once"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(8, 8, 8, 0);
    bar->addWidget(m_tabs);
    bar->addStretch();
    column->addLayout(bar);
    column->addWidget(m_accuracy);
    column->addWidget(m_test);
    column->addWidget(m_poke);
    connect(m_tabs, &QTabBar::currentChanged, this, [this] {
        show(page());
        emit chosen(page());
    });
    show(page());
}

void MeasureColumn::show(MeasurePage page) {
    m_accuracy->setVisible(page == MeasurePage::Accuracy);
    m_test->setVisible(page == MeasurePage::VirtualTest);
    m_poke->setVisible(page == MeasurePage::Poke);
}

} // namespace esm
