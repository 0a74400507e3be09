#pragma once

#include "app/editor/window/shortcuts.h"

#include <QObject>

namespace esm {

/// Keeps the keys of all actions in the settings, asks for others, and says why a key does nothing.
class ShortcutController : public QObject {
    Q_OBJECT

public:
    /// The keys that the actions have now are the usual ones.
    ShortcutController(QWidget& window, const Actions& actions);

    void restore(const QSettings& settings);

signals:
    /// Something for the line at the bottom.
    void message(const QString& text);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void askForKeys();

    QWidget& m_window;
    const std::vector<ShortcutRow> m_rows;
    const ShortcutKeys m_usual;
};

} // namespace esm
