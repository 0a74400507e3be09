#include "app/editor/window/peek_key.h"

#include <QCoreApplication>

#include <utility>

namespace esm {

namespace {

constexpr qint64 longestTap = 400; // ms

} // namespace

PeekKey::PeekKey(QAction& action, PassingTime clock)
    : QObject(&action), m_action(action), m_clock(std::move(clock)) {
    action.setAutoRepeat(false);
    connect(&action, &QAction::triggered, this, [this] { m_hasSwitched = m_down.has_value(); });
    QCoreApplication::instance()->installEventFilter(this);
}

/// A key that is a shortcut is announced as an override and never pressed, but it is released.
bool PeekKey::eventFilter(QObject*, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyRelease) return false;
    const auto& key = static_cast<const QKeyEvent&>(*event);
    if (key.isAutoRepeat() || !isOwn(key)) return false;
    if (event->type() == QEvent::KeyRelease)
        release();
    else if (!m_down)
        m_down = m_clock();
    return false;
}

bool PeekKey::isOwn(const QKeyEvent& event) const {
    for (const QKeySequence& own : m_action.shortcuts())
        if ((own[0] & ~int(Qt::KeyboardModifierMask)) == event.key()) return true;
    return false;
}

void PeekKey::release() {
    const bool wasHeld = m_down && m_clock() - *m_down > longestTap;
    const bool hasSwitched = std::exchange(m_hasSwitched, false);
    m_down.reset();
    if (wasHeld && hasSwitched) m_action.trigger();
}

} // namespace esm
