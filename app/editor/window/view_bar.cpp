#include "app/editor/window/view_bar.h"

#include "app/editor/window/layout.h"
#include "widgets/inputs/control_keys.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>

namespace esm {

namespace {

constexpr QPoint corner(14, 14);
constexpr int sliderWidth = 150, percentWidth = 40; // pixels

} // namespace

ViewBar::ViewBar(const Actions& actions, QWidget* view)
    : QFrame(view), m_cut(new QWidget(this)), m_side(new QComboBox(m_cut)),
      m_share(new QSlider(Qt::Horizontal, m_cut)), m_percent(new QLabel(m_cut)) {
    setObjectName(QStringLiteral("viewBar"));
    setCursor(Qt::ArrowCursor);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 4, 4, 4);
    row->setSpacing(6);
    auto* show = new QToolButton(this);
    show->setObjectName(QStringLiteral("showButton"));
    show->setText(tr("Show"));
    show->setToolTip(tr("What of the organ is drawn, its colours, and how it is looked at"));
    show->setPopupMode(QToolButton::InstantPopup);
    show->setFocusPolicy(Qt::TabFocus);
    auto* menu = new QMenu(show);
    fillShownMenu(menu, actions);
    menu->addSeparator();
    menu->addActions({actions.cut, actions.lookFromWithin, actions.orthographic});
    show->setMenu(menu);
    row->addWidget(show);
    row->addWidget(m_cut);
    buildCut(actions);
    move(corner);
}

void ViewBar::buildCut(const Actions& actions) {
    auto* row = new QHBoxLayout(m_cut);
    row->setContentsMargins(0, 0, 4, 0);
    row->setSpacing(6);
    m_side->setObjectName(QStringLiteral("cutSide"));
    m_side->addItems({tr("Cut from the viewer"), tr("Cut from the right, +x"), tr("Cut from the left, −x"),
                      tr("Cut from the top, +y"), tr("Cut from the bottom, −y"), tr("Cut from the front, +z"),
                      tr("Cut from the back, −z")});
    m_side->setAccessibleName(tr("Side of the cut"));
    m_side->setToolTip(tr("The side from which the organ is hidden"));
    guardFromWheel(*m_side);
    m_share->setObjectName(QStringLiteral("cutShare"));
    m_share->setRange(0, 1000);
    m_share->setPageStep(50);
    m_share->setSingleStep(5);
    m_share->setValue(500);
    m_share->setFixedWidth(sliderWidth);
    m_share->setAccessibleName(tr("Part of the organ that is hidden"));
    m_share->setToolTip(tr("How much of the organ's length is hidden, from that side on"));
    m_percent->setFixedWidth(percentWidth);
    m_percent->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    for (QWidget* control :
         {static_cast<QWidget*>(m_side), static_cast<QWidget*>(m_share), static_cast<QWidget*>(m_percent)})
        row->addWidget(control);
    const auto tell = [this] {
        m_percent->setText(tr("%1 %").arg(m_share->value() / 10));
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
