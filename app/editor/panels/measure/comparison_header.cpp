#include "app/editor/panels/measure/comparison_header.h"

#include "widgets/inputs/enabling.h"

#include <QVariant>

namespace esm {

namespace {

constexpr int roomForTitle = 160; // pixels

}

ComparisonHeader::ComparisonHeader(const QString& subject, QWidget* parent)
    : QWidget(parent), m_all(new QBoxLayout(QBoxLayout::LeftToRight, this)), m_comparing(new QHBoxLayout),
      m_saving(new QHBoxLayout), m_title(new ElidedLabel(this)),
      m_keep(new QPushButton(tr("Keep to compare"), this)),
      m_clear(new QPushButton(tr("Clear before"), this)), m_table(new QPushButton(tr("Save table…"), this)),
      m_chart(new QPushButton(tr("Save chart…"), this)) {
    m_all->setContentsMargins(0, 0, 0, 0);
    m_all->setSpacing(8);
    m_title->setProperty("quiet", true);
    m_comparing->addWidget(m_title, 1);
    m_saving->addStretch();
    m_all->addLayout(m_comparing, 1);
    m_all->addLayout(m_saving);
    m_keep->setObjectName(QStringLiteral("keep") + subject);
    m_clear->setObjectName(QStringLiteral("clear") + subject);
    m_table->setObjectName(QStringLiteral("save%1Table").arg(subject));
    m_chart->setObjectName(QStringLiteral("save%1Chart").arg(subject));
    for (QPushButton* button : {m_keep, m_clear})
        add(button, m_comparing);
    for (QPushButton* button : {m_table, m_chart})
        add(button, m_saving);
    connect(m_keep, &QPushButton::clicked, this, &ComparisonHeader::keepAsked);
    connect(m_clear, &QPushButton::clicked, this, &ComparisonHeader::clearAsked);
    connect(m_table, &QPushButton::clicked, this, &ComparisonHeader::tableAsked);
    connect(m_chart, &QPushButton::clicked, this, &ComparisonHeader::chartAsked);
}

void ComparisonHeader::add(QPushButton* button, QBoxLayout* row) {
    button->setFocusPolicy(Qt::TabFocus);
    row->addWidget(button);
}

void ComparisonHeader::setState(const State& state, const Texts& texts) {
    enable(m_keep, state.isMeasured && state.canBeKept, texts.keep,
           state.isMeasured ? texts.isKept : texts.hasNone);
    enable(m_clear, state.hasFormer, texts.clear, texts.hasNoFormer);
    enable(m_table, state.isMeasured, texts.table, texts.hasNone);
    enable(m_chart, state.isMeasured, tr("Write the chart as a picture (.png or .svg)"), texts.hasNone);
}

void ComparisonHeader::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const int inOneRow = m_comparing->sizeHint().width() - m_title->sizeHint().width() + m_all->spacing() +
                         m_saving->sizeHint().width();
    const bool isNarrow = width() < inOneRow + roomForTitle;
    m_all->setDirection(isNarrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

} // namespace esm
