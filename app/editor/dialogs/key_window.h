#pragma once

#include <QApplication>
#include <QPointer>
#include <QWidget>

namespace esm {

/// The window of this program that has the keys, to have them again once a dialog in front of it is closed:
/// not every desktop gives them back.
class KeyWindow {
public:
    /// @param otherwise has the keys where no window has, or where that one is gone by then; may be null
    explicit KeyWindow(QWidget* otherwise) : m_window(QApplication::activeWindow()), m_otherwise(otherwise) {}

    void activateAgain() const {
        const bool isThere = m_window && m_window->isVisible();
        if (QWidget* window = isThere ? m_window.data() : m_otherwise.data()) window->activateWindow();
    }

private:
    QPointer<QWidget> m_window, m_otherwise;
};

} // namespace esm
