#include "widgets/inputs/control_keys.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
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
    WheelFilter(Turning turning, QObject* parent) : QObject(parent), m_turning(turning) {}

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Wheel) return false;
        if (m_turning == Turning::WithFocus && static_cast<QWidget*>(watched)->hasFocus()) return false;
        event->ignore();
        return true;
    }

private:
    Turning m_turning;
};

} // namespace

void keepControlKeys(QWidget& window) {
    window.installEventFilter(new ControlKeysFilter(&window));
}

bool isRedo(const QKeyEvent& key) {
    return key.matches(QKeySequence::Redo) ||
           (key.key() == Qt::Key_Y && key.modifiers() == Qt::ControlModifier);
}

void guardFromWheel(QWidget& control, Turning turning) {
    // The wheel itself must not give the focus.
    control.setFocusPolicy(Qt::StrongFocus);
    control.installEventFilter(new WheelFilter(turning, &control));
}

} // namespace esm
