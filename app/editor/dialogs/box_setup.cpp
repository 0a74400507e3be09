#include "app/editor/dialogs/box_setup.h"

#include <QAbstractButton>
#include <QApplication>
#include <QKeyEvent>
#include <QShortcut>

namespace esm {

namespace {

/// Notes an Escape that closes an open list. Qt hides the list before it looks for shortcuts of the key, so
/// that these find none open.
class ListClosing : public QObject {
public:
    explicit ListClosing(QDialog& dialog) : QObject(&dialog) { qApp->installEventFilter(this); }

    bool isByThisKey() const { return m_isByThisKey; }

protected:
    bool eventFilter(QObject* receiver, QEvent* event) override {
        if (event->type() == QEvent::KeyRelease) m_isByThisKey = false;
        // It comes to the list, and once that is hidden to what lies around it.
        if (event->type() == QEvent::ShortcutOverride && QApplication::activePopupWidget())
            m_isByThisKey = static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
        // Where no shortcut takes the key, the dialog would.
        if (event->type() == QEvent::KeyPress && m_isByThisKey) return true;
        return QObject::eventFilter(receiver, event);
    }

private:
    bool m_isByThisKey = false;
};

} // namespace

void setUpBox(QMessageBox& box, const char* name) {
    box.setObjectName(QLatin1String(name));
    // A box takes letters without Alt too: none discards work.
    for (const auto& [which, text] : {std::pair(QMessageBox::Save, QObject::tr("&Save")),
                                      {QMessageBox::Cancel, QObject::tr("&Cancel")},
                                      {QMessageBox::Ok, QObject::tr("&OK")}})
        if (QAbstractButton* button = box.button(which)) button->setText(text);
}

void rejectOnEscape(QDialog& dialog) {
    const auto* closed = new ListClosing(dialog);
    QObject::connect(new QShortcut(Qt::Key_Escape, &dialog), &QShortcut::activated, &dialog,
                     [&dialog, closed] {
                         if (!closed->isByThisKey()) dialog.reject();
                     });
}

} // namespace esm
