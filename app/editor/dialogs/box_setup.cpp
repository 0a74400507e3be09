#include "app/editor/dialogs/box_setup.h"

#include <QAbstractButton>
#include <QApplication>
#include <QShortcut>

namespace esm {

void setUpBox(QMessageBox& box, const char* name) {
    box.setObjectName(QLatin1String(name));
    // A box takes letters without Alt too: none discards work.
    for (const auto& [which, text] : {std::pair(QMessageBox::Save, QObject::tr("&Save")),
                                      {QMessageBox::Cancel, QObject::tr("&Cancel")},
                                      {QMessageBox::Ok, QObject::tr("&OK")}})
        if (QAbstractButton* button = box.button(which)) button->setText(text);
}

void rejectOnEscape(QDialog& dialog) {
    QObject::connect(new QShortcut(Qt::Key_Escape, &dialog), &QShortcut::activated, &dialog, [&dialog] {
        if (QWidget* list = QApplication::activePopupWidget())
            list->close();
        else
            dialog.reject();
    });
}

} // namespace esm
