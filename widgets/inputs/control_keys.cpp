#include "widgets/inputs/control_keys.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QSlider>

namespace esm {

namespace {

bool answers(const QWidget* control, int key) {
    const bool choice = qobject_cast<const QComboBox*>(control);
    if (key == Qt::Key_Space) return choice || qobject_cast<const QAbstractButton*>(control);
    if (key != Qt::Key_Home && key != Qt::Key_End) return false;
    return choice || qobject_cast<const QAbstractSlider*>(control) ||
           qobject_cast<const QAbstractItemView*>(control);
}

/// A key goes from the focused control up to the window before its shortcuts are asked.
class ControlKeysFilter : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() != QEvent::ShortcutOverride) return false;
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->modifiers() != Qt::NoModifier || !answers(QApplication::focusWidget(), key->key()))
            return false;
        event->accept();
        return true;
    }
};

class WheelFilter : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus()) return false;
        event->ignore();
        return true;
    }
};

} // namespace

void keepControlKeys(QWidget& window) {
    window.installEventFilter(new ControlKeysFilter(&window));
}

void guardFromWheel(QWidget& control) {
    // The wheel itself must not give the focus.
    control.setFocusPolicy(Qt::StrongFocus);
    control.installEventFilter(new WheelFilter(&control));
}

} // namespace esm
