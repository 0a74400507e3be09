#include "app/editor/dialogs/split_question.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/dialogs/box_setup.h"

#include <QMessageBox>
#include <QPushButton>

namespace esm {

bool mayRemoveSplits(QWidget& window, const Scene& scene) {
    if (scene.splits.empty()) return true;
    return ask(window, [&] {
        QMessageBox box(QMessageBox::Question, QObject::tr("Simulate other nodes"),
                        QObject::tr("The scene's splits will be removed: other nodes have other edges."),
                        QMessageBox::Cancel, &window);
        setUpBox(box, "splitsGoBox");
        QPushButton* remove = box.addButton(QObject::tr("&Remove splits"), QMessageBox::AcceptRole);
        box.setDefaultButton(remove);
        box.exec();
        return box.clickedButton() == remove;
    });
}

} // namespace esm
