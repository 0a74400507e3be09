// Edits a document with a journal at random until it is killed. Tells what it does line by line, with times
// of the machine's steady clock in ns:
//   C n t digest   state n was committed; told before the journal hears of it
//   P n task       it is written, at the latest, with this task of the writer
//   B task t, S task t   the writer begins with tasks up to this one; they are on the disk
//   T t            every 20 ms, where the machine lets the program run
#include "app/editor/document/journal.h"
#include "tests/app/editor/document/random_edits.h"
#include "tests/app/editor/document/steady_time.h"

#include <QCoreApplication>
#include <QTimer>

#include <thread>
#include <unistd.h>

using namespace esm;

namespace {

/// In one piece, as pipes take short lines.
void tell(const std::string& line) {
    const std::string text = line + '\n';
    if (::write(STDOUT_FILENO, text.data(), text.size()) < 0) std::_Exit(1);
}

void tellTimes() {
    for (;;) {
        tell("T " + std::to_string(steadyTime()));
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

JournalHabits watchedHabits() {
    JournalHabits habits;
    habits.bounds.leastGrowth = 64 << 10; // so that it is written anew now and then
    const auto telling = [](const char* what) {
        return [what](std::uint64_t task) {
            tell(what + std::to_string(task) + ' ' + std::to_string(steadyTime()));
        };
    };
    habits.begins = telling("B ");
    habits.synced = telling("S ");
    return habits;
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    if (argc != 3) return 2;
    const auto seed = static_cast<std::uint32_t>(std::stoul(argv[2]));
    Document document(projectToEdit());
    document.replace(projectToEdit(), std::nullopt, Origin::Unsaved);
    Selection selection(document);
    DocumentDigests digests;
    int number = -1;
    const auto tellState = [&] {
        const std::string digest = digests.of(document.state());
        tell("C " + std::to_string(++number) + ' ' + std::to_string(steadyTime()) + ' ' + digest);
    };
    tellState();
    QObject::connect(&document, &Document::stepped, tellState);
    Journal journal(document, selection, argv[1], nullptr, watchedHabits());
    const auto tellTask = [&] {
        tell("P " + std::to_string(number) + ' ' + std::to_string(journal.lastPut()));
    };
    tellTask();
    QObject::connect(&document, &Document::stepped, tellTask);
    RandomEdits edits(document, selection, seed, 200); // drags of some seconds
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        edits.next();
        timer.setInterval(edits.below(30) == 0 ? 400 : static_cast<int>(edits.below(30)));
    });
    timer.start(0);
    std::thread(tellTimes).detach();
    return QCoreApplication::exec();
}
