#include "app/editor/window/recovery.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/box_setup.h"
#include "app/editor/dialogs/long_work.h"

#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

namespace esm {

namespace {

/// None: it stays for the next start.
enum class UnsavedWork { BringBack, Discard };

/// Journals may be long. Those that nobody waits for are offered at the next start.
std::vector<LeftBehind> lookForUnsavedWork(QWidget& window, const Journal& journal) {
    std::vector<LeftBehind> found;
    attempt(&window, QObject::tr("Unsaved work cannot be looked for"), [&] {
        found = computeLong(
            &window, QObject::tr("Looking for unsaved work"),
            [&](const Progress& progress) { return journal.leftBehind(progress); }, Cancelling::Offered);
    });
    return found;
}

std::optional<UnsavedWork> askAboutUnsavedWork(QWidget& window, const LeftBehind& work) {
    const QString title = work.former.title.isEmpty() ? QObject::tr("an organ") : work.former.title;
    QMessageBox box(QMessageBox::Question, QObject::tr("Unsaved work"),
                    QObject::tr("Bring back the unsaved work?"), QMessageBox::Discard, &window);
    setUpBox(box, "leftBehindBox");
    box.setInformativeText(QObject::tr("The program ended without saving %1. It was last changed on %2.")
                               .arg(title, QLocale().toString(work.written, QLocale::ShortFormat)));
    QPushButton* restore = box.addButton(QObject::tr("&Bring back"), QMessageBox::AcceptRole);
    QPushButton* later = box.addButton(QObject::tr("&Later"), QMessageBox::RejectRole);
    later->setToolTip(QObject::tr("Keep it, and ask again when the program starts next"));
    box.setDefaultButton(restore);
    ask(window, [&] { return box.exec(); });
    if (box.clickedButton() == restore) return UnsavedWork::BringBack;
    return box.clickedButton() == box.button(QMessageBox::Discard) ? std::optional(UnsavedWork::Discard)
                                                                   : std::nullopt;
}

std::optional<JournalView> restoreUnsavedWork(QWidget& window, Document& document, Journal& journal,
                                              LeftBehind work) {
    std::optional<JournalView> view;
    attempt(&window, QObject::tr("The unsaved work cannot be read"), [&] {
        const BroughtBack back = computeLong(
            &window, QObject::tr("Bringing back the unsaved work"),
            [&](const Progress& progress) { return bringBack(work, progress); }, Cancelling::Offered);
        document.restore(back.state);
        journal.takeOver(std::move(work));
        view = back.view;
        tell(&window, QObject::tr("The work was brought back, but something is wrong with it"),
             back.warnings);
    });
    return view;
}

} // namespace

std::optional<JournalView> offerLeftBehind(QWidget& window, Document& document, Journal& journal) {
    std::vector<LeftBehind> found = lookForUnsavedWork(window, journal);
    if (found.empty()) return std::nullopt;
    LeftBehind& latest = found.front();
    const auto wanted = askAboutUnsavedWork(window, latest);
    if (wanted == UnsavedWork::BringBack)
        return restoreUnsavedWork(window, document, journal, std::move(latest));
    if (wanted == UnsavedWork::Discard) discard(latest);
    return std::nullopt;
}

} // namespace esm
