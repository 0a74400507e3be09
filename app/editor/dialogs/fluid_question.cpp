#include "app/editor/dialogs/fluid_question.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/dialogs/box_setup.h"
#include "core/model/scene_cavities.h"

#include <QMessageBox>
#include <QPushButton>

namespace esm {

bool mayRemoveFluids(QWidget& window, const Scene& scene, const Detail& chosen) {
    const std::size_t parts = fluidParts(scene).size();
    if (parts == 0 || chosen.kind != Detail::Kind::Filled) return true;
    const QString why = chosen.filling && isWall(*chosen.filling)
                            ? QObject::tr("within a wall of prisms a fluid is not computed yet.")
                            : QObject::tr("a lattice fills the body, and leaves no room for it.");
    const QString what =
        parts == 1
            ? QObject::tr("The organ's fluid, and what presses from within, will be removed: %1").arg(why)
            : QObject::tr("The fluid in %1 parts, and what presses from within, will be removed: %2")
                  .arg(parts)
                  .arg(why);
    return ask(window, [&] {
        QMessageBox box(QMessageBox::Question, QObject::tr("Inside of the organ"), what, QMessageBox::Cancel,
                        &window);
        setUpBox(box, "fluidsGoBox");
        QPushButton* remove = box.addButton(QObject::tr("&Remove fluid"), QMessageBox::AcceptRole);
        box.setDefaultButton(remove);
        box.exec();
        return box.clickedButton() == remove;
    });
}

} // namespace esm
