#include "app/editor/window/top_bar.h"

#include "widgets/inputs/action_texts.h"

#include <QEvent>
#include <QFontMetrics>
#include <QFrame>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>

namespace esm {

namespace {

/// A button that is an action: it follows its text, state and tool tip.
QPushButton* pushButton(QAction* action, QWidget* parent) {
    auto* button = new QPushButton(parent);
    button->setCheckable(action->isCheckable());
    // A click leaves the keys where they were.
    button->setFocusPolicy(Qt::TabFocus);
    const auto follow = [button, action] {
        button->setText(plainText(action));
        button->setToolTip(action->toolTip());
        button->setEnabled(action->isEnabled());
        button->setChecked(action->isChecked());
    };
    follow();
    // Bold when chosen: the room for it is kept, so that nothing moves.
    if (action->isCheckable()) {
        QFont bold = button->font();
        bold.setBold(true);
        button->setMinimumWidth(QFontMetrics(bold).horizontalAdvance(button->text()) + 36);
    }
    QObject::connect(action, &QAction::changed, button, follow);
    QObject::connect(button, &QPushButton::clicked, action, [follow, action] {
        action->trigger();
        follow();
    });
    return button;
}

QToolButton* iconButton(QAction* action, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setDefaultAction(action);
    button->setObjectName(QStringLiteral("barButton"));
    button->setIconSize({18, 18});
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

QWidget* workspaceSwitch(const Actions& actions, QWidget* parent) {
    auto* frame = new QFrame(parent);
    frame->setObjectName(QStringLiteral("workspaces"));
    auto* row = new QHBoxLayout(frame);
    row->setContentsMargins(3, 3, 3, 3);
    row->setSpacing(2);
    for (QAction* workspace : {actions.tissue, actions.texture, actions.measure})
        row->addWidget(pushButton(workspace, frame));
    return frame;
}

QPushButton* playButton(const Actions& actions, QWidget* parent) {
    QPushButton* play = pushButton(actions.play, parent);
    play->setProperty("primary", true);
    play->setObjectName(QStringLiteral("playButton"));
    // "Pause" and "Play" take the same room.
    play->setMinimumWidth(84);
    return play;
}

} // namespace

TopBar::TopBar(const Actions& actions, const std::vector<QWidget*>& toolOptions, QWidget* parent)
    : QToolBar(tr("Top bar"), parent), m_options(new QWidget(this)), m_toolOptions(toolOptions) {
    setObjectName(QStringLiteral("topBar"));
    setMovable(false);
    setContextMenuPolicy(Qt::PreventContextMenu);
    auto* content = new QWidget(this);
    m_rows = new QVBoxLayout(content);
    m_rows->setContentsMargins(10, 6, 10, 6);
    m_rows->setSpacing(6);
    m_row = new QHBoxLayout;
    m_row->setSpacing(8);
    m_rows->addLayout(m_row);

    m_left = addSide(content);
    m_left->addWidget(iconButton(actions.undo, content));
    m_left->addWidget(iconButton(actions.redo, content));
    addOptions(toolOptions);
    m_left->addStretch();
    m_workspaces = workspaceSwitch(actions, content);
    m_row->addWidget(m_workspaces);
    QHBoxLayout* right = addSide(content);
    right->addStretch();
    right->addWidget(pushButton(actions.reset, content));
    right->addWidget(playButton(actions, content));
    right->addWidget(pushButton(actions.exportPackage, content));

    addWidget(content);
    content->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

/// Both sides take the same share, so that the workspaces stay in the middle.
QHBoxLayout* TopBar::addSide(QWidget* content) {
    auto* side = new QWidget(content);
    auto* row = new QHBoxLayout(side);
    row->setContentsMargins(0, 0, 0, 0);
    side->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_row->addWidget(side, 1);
    return row;
}

void TopBar::addOptions(const std::vector<QWidget*>& toolOptions) {
    auto* row = new QHBoxLayout(m_options);
    row->setContentsMargins(0, 0, 0, 0);
    for (QWidget* options : toolOptions) {
        row->addWidget(options);
        options->installEventFilter(this);
    }
    row->addStretch();
    m_left->addWidget(m_options);
}

void TopBar::resizeEvent(QResizeEvent* event) {
    QToolBar::resizeEvent(event);
    arrange();
}

bool TopBar::eventFilter(QObject* watched, QEvent* event) {
    const bool isOther = event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent ||
                         event->type() == QEvent::LayoutRequest;
    if (isOther) arrange();
    return QToolBar::eventFilter(watched, event);
}

void TopBar::arrange() {
    int needed = 0;
    for (QWidget* options : m_toolOptions)
        if (!options->isHidden()) needed = std::max(needed, options->sizeHint().width());
    for (int i = 0; i < m_left->count(); ++i) {
        const QWidget* button = m_left->itemAt(i)->widget();
        if (button && button != m_options) needed += button->sizeHint().width() + m_left->spacing();
    }
    const QMargins around = m_rows->contentsMargins();
    const int sides = width() - around.left() - around.right() - m_workspaces->sizeHint().width();
    const bool isBeside = needed <= sides / 2 - m_row->spacing();
    if (isBeside != (m_left->indexOf(m_options) >= 0)) {
        if (isBeside)
            m_left->insertWidget(m_left->count() - 1, m_options); // before the stretch
        else
            m_rows->addWidget(m_options);
    }
    m_options->setVisible(std::any_of(m_toolOptions.begin(), m_toolOptions.end(),
                                      [](const QWidget* options) { return !options->isHidden(); }));
}

} // namespace esm
