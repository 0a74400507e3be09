#include "app/editor/window/view_bar.h"

#include "app/editor/window/layout.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/spoken.h"

#include <QGridLayout>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

namespace esm {

namespace {

constexpr QPoint corner(14, 14);
constexpr int cutWidth = 150, percentWidth = 38; // pixels

} // namespace

ViewBar::ViewBar(const Actions& actions, QWidget* view)
    : QFrame(view), m_cut(new QWidget(this)), m_side(new QComboBox(m_cut)), m_share(new ValueSlider(m_cut)),
      m_percent(new QLabel(m_cut)) {
    setObjectName(QStringLiteral("viewBar"));
    setCursor(Qt::ArrowCursor);
    auto* column = new QVBoxLayout(this); // a narrow view has its cube beside it
    column->setContentsMargins(4, 4, 4, 4);
    column->setSpacing(4);
    auto* show = new QToolButton(this);
    show->setObjectName(QStringLiteral("showButton"));
    show->setText(tr("Show"));
    show->setToolTip(tr("What of the organ is drawn, its colours, and how it is looked at"));
    show->setPopupMode(QToolButton::InstantPopup);
    show->setFocusPolicy(Qt::TabFocus);
    auto* menu = new QMenu(show);
    fillShownMenu(menu, actions);
    menu->addSeparator();
    menu->addActions({actions.cut, actions.lookFromWithin, actions.lookThroughPhoto, actions.orthographic,
                      actions.endoscopeLight});
    show->setMenu(menu);
    column->addWidget(show, 0, Qt::AlignLeft);
    column->addWidget(m_cut);
    buildCut(actions);
    move(corner);
}

void ViewBar::buildCut(const Actions& actions) {
    m_side->setObjectName(QStringLiteral("cutSide"));
    m_side->addItems({tr("From the viewer"), tr("From the right, +x"), tr("From the left, −x"),
                      tr("From the top, +y"), tr("From the bottom, −y"), tr("From the front, +z"),
                      tr("From the back, −z")});
    nameChoice(*m_side, tr("Side of the cut"));
    m_side->setToolTip(tr("The side from which the organ is hidden"));
    guardFromWheel(*m_side);
    m_share->setObjectName(QStringLiteral("cutShare"));
    m_share->setRange(0, 1000);
    m_share->setPageStep(50);
    m_share->setSingleStep(10); // a percent, as is shown
    m_share->setValue(500);
    m_share->setScale(0, 100);
    m_share->setAccessibleName(tr("Part of the organ that is hidden"));
    m_share->setToolTip(tr("How much of the organ's length is hidden, from that side on"));
    m_percent->setFixedWidth(percentWidth);
    m_percent->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_cut->setFixedWidth(cutWidth);
    auto* grid = new QGridLayout(m_cut);
    grid->setContentsMargins(2, 0, 2, 2);
    grid->setSpacing(4);
    grid->addWidget(m_side, 0, 0, 1, 2);
    grid->addWidget(m_share, 1, 0);
    grid->addWidget(m_percent, 1, 1);
    const auto tell = [this] {
        m_percent->setText(tr("%1 %").arg(m_share->value() / 10));
        m_share->setSpoken(m_percent->text());
        emit cutChanged();
    };
    connect(m_share, &QSlider::valueChanged, this, tell);
    connect(m_side, QOverload<int>::of(&QComboBox::currentIndexChanged), this, tell);
    connect(actions.cut, &QAction::toggled, this, &ViewBar::showCut);
    tell();
    showCut(actions.cut->isChecked());
}

void ViewBar::showCut(bool on) {
    m_cut->setVisible(on);
    adjustSize();
}

Cut ViewBar::cut() const {
    return {static_cast<CutSide>(m_side->currentIndex()), m_share->value() / 1000.0};
}

} // namespace esm
