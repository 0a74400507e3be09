#include "app/editor/dialogs/box_setup.h"

#include <QAbstractButton>

namespace esm {

void setUpBox(QMessageBox& box, const char* name) {
    box.setObjectName(QLatin1String(name));
    // A box takes letters without Alt too: none discards work.
    for (const auto& [which, text] : {std::pair(QMessageBox::Save, QObject::tr("&Save")),
                                      {QMessageBox::Cancel, QObject::tr("&Cancel")},
                                      {QMessageBox::Ok, QObject::tr("&OK")}})
        if (QAbstractButton* button = box.button(which)) button->setText(text);
}

} // namespace esm
