#pragma once

#include "widgets/inputs/action_texts.h"

#include <QAbstractButton>

namespace esm {

/// Enables a control; its tool tip says what it does, or why it cannot be used now.
template<typename Control> void enable(Control* control, bool on, const QString& does, const QString& why) {
    control->setEnabled(on);
    control->setToolTip(on ? does : why);
}

/// Makes a button trigger an action; it is enabled and explained as the action is.
inline void follow(QAbstractButton* button, QAction* action) {
    const auto update = [button, action] {
        button->setEnabled(action->isEnabled());
        button->setToolTip(action->toolTip());
    };
    update();
    QObject::connect(action, &QAction::changed, button, update);
    QObject::connect(button, &QAbstractButton::clicked, action, &QAction::trigger);
}

} // namespace esm
