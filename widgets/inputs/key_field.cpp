#include "widgets/inputs/key_field.h"

#include <QKeyEvent>

namespace esm {

namespace {

bool isHeldAlone(int key) {
    return key == Qt::Key_Shift || key == Qt::Key_Control || key == Qt::Key_Alt || key == Qt::Key_Meta ||
           key == Qt::Key_AltGr || key == Qt::Key_CapsLock || key == Qt::Key_unknown || key == 0;
}

bool isTheWindows(const QKeyEvent& event) {
    return event.key() == Qt::Key_Escape || event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

/// The shift that a sign takes belongs to the sign.
QKeySequence keyOf(const QKeyEvent& event) {
    Qt::KeyboardModifiers held = event.modifiers() & ~(Qt::KeypadModifier | Qt::GroupSwitchModifier);
    const QString text = event.text();
    const bool isSign = !text.isEmpty() && text[0].isPrint() && !text[0].isLetter() && !text[0].isSpace();
    if (isSign) held &= ~Qt::ShiftModifier;
    return QKeySequence(event.key() | static_cast<int>(held));
}

} // namespace

KeyField::KeyField(QWidget* parent) : QLineEdit(parent) {
    setReadOnly(true);
    setContextMenuPolicy(Qt::NoContextMenu);
}

void KeyField::setKey(const QKeySequence& key) {
    setText(key.toString(QKeySequence::NativeText));
}

/// Before a shortcut of its window answers.
bool KeyField::event(QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride) return QLineEdit::event(event);
    if (!isTheWindows(static_cast<QKeyEvent&>(*event))) event->accept();
    return true;
}

void KeyField::keyPressEvent(QKeyEvent* event) {
    if (isHeldAlone(event->key()) || isTheWindows(*event)) return event->ignore();
    emit keyTyped(keyOf(*event));
}

} // namespace esm
