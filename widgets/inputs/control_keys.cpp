#include "widgets/inputs/control_keys.h"

#include "widgets/inputs/item_list.h"
#include "widgets/inputs/number_field.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QPushButton>
#include <QSlider>
#include <QTabBar>
#include <QTimer>

namespace esm {

namespace {

bool answers(const QWidget* control, int key) {
    const bool choice = qobject_cast<const QComboBox*>(control);
    if (key == Qt::Key_Space) return choice || qobject_cast<const QAbstractButton*>(control);
    if (key != Qt::Key_Home && key != Qt::Key_End) return false;
    // A list of a few names leaves them to the window.
    const bool table =
        qobject_cast<const QAbstractItemView*>(control) && !qobject_cast<const ItemList*>(control);
    return choice || table || qobject_cast<const QAbstractSlider*>(control);
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

bool isEnter(const QEvent& event) {
    if (event.type() != QEvent::KeyPress) return false;
    const int key = static_cast<const QKeyEvent&>(event).key();
    return key == Qt::Key_Return || key == Qt::Key_Enter;
}

/// What Enter leaves: not a field whose text is to be corrected.
bool isDone(const QWidget* control) {
    const auto* number = qobject_cast<const NumberField*>(control);
    return qobject_cast<const QLineEdit*>(control) && (!number || number->refusal().isEmpty());
}

/// Whether a control that the mouse has answered needs no keys; who goes to it by the keyboard stays.
bool isAnswered(const QObject* control) {
    return qobject_cast<const QPushButton*>(control) || qobject_cast<const QTabBar*>(control) ||
           qobject_cast<const QComboBox*>(control);
}

class KeysHomeFilter : public QObject {
public:
    KeysHomeFilter(QWidget& window, QWidget& home) : QObject(&window), m_window(window), m_home(home) {
        window.installEventFilter(this);
        for (QComboBox* choice : window.findChildren<QComboBox*>())
            choice->view()->installEventFilter(this);
        for (QPushButton* button : window.findChildren<QPushButton*>())
            button->installEventFilter(this);
        for (QTabBar* tabs : window.findChildren<QTabBar*>())
            tabs->installEventFilter(this);
        m_afterwards.setSingleShot(true);
        connect(&m_afterwards, &QTimer::timeout, this, [this] {
            if (isAnswered(m_window.focusWidget())) m_home.setFocus();
        });
    }

    bool eventFilter(QObject* watched, QEvent* event) override {
        const bool isLost = event->type() == QEvent::WindowActivate && !m_window.focusWidget();
        // Enter comes here from a field that has taken its text.
        if (watched == &m_window && (isLost || (isEnter(*event) && isDone(m_window.focusWidget()))))
            m_home.setFocus();
        // The list of a choice closes before the choice is made, and a button acts after the mouse let it go;
        // either may open a window.
        const auto answer = isAnswered(watched) ? QEvent::MouseButtonRelease : QEvent::Hide;
        if (watched != &m_window && event->type() == answer) m_afterwards.start(0);
        return false;
    }

private:
    QWidget &m_window, &m_home;
    QTimer m_afterwards; ///< once what the mouse did is done
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

void giveKeysHome(QWidget& window, QWidget& home) {
    new KeysHomeFilter(window, home);
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
