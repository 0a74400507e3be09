#pragma once

#include <QKeySequence>
#include <QLineEdit>

namespace esm {

/// Shows a key and takes the one that is pressed in it. Tab leaves it; Esc and Enter are its window's.
class KeyField : public QLineEdit {
    Q_OBJECT

public:
    explicit KeyField(QWidget* parent = nullptr);

    /// Shows a key, announcing nothing.
    void setKey(const QKeySequence& key);

signals:
    /// With what was held besides; never a key such as Ctrl alone.
    void keyTyped(const QKeySequence& key);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
};

} // namespace esm
