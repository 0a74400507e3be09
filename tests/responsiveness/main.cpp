// Measures how a window keeps up while its tissue plays and is edited: how soon it answers, how far frames
// lie apart, and how long a slider's move takes to be seen; of mesh files, how it answers while they are
// imported. In a virtual display it draws by software.
//   responsiveness [NODES|MESH…]   10000 and 16000 nodes unless given

#include "app/editor/window/application.h"
#include "tests/responsiveness/organ.h"
#include "tests/responsiveness/window_watch.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDeadlineTimer>
#include <QDialog>
#include <QEventLoop>
#include <QSettings>
#include <QStandardPaths>
#include <QTimer>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <vector>

using namespace responsiveness;

namespace {

constexpr int moves = 20, ticks = 200;
constexpr int betweenMoves = 400, betweenTicks = 16; // ms
constexpr int patience = 60000;                      // ms

/// As the program itself waits for events. QTest's waiting sleeps for 10 ms between them.
void wait(int milliseconds) {
    QEventLoop loop;
    QTimer::singleShot(milliseconds, Qt::PreciseTimer, &loop, &QEventLoop::quit);
    loop.exec();
}

/// Ends the program where it does not come about.
template<class Condition> void waitFor(const char* what, const Condition& condition) {
    const QDeadlineTimer deadline(patience);
    QTimer wakes;
    wakes.start(100);
    while (!condition() && !deadline.hasExpired())
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    if (condition()) return;
    std::fprintf(stderr, "Waited in vain for %s.\n", what);
    std::exit(1);
}

/// The region's first slider to and fro, as a drag of its handle.
void moveSlider(esm::MainWindow& window, int move) {
    const esm::RegionId region{1};
    window.document().edit(QStringLiteral("slider"),
                           [&](esm::Project& project) {
                               esm::Region& edited = partOf(project.regions, region);
                               const esm::FuzzyVariable& input = edited.system->inputs.front();
                               const double place = 0.3 + 0.4 * (move % 20) / 20;
                               setInput(edited, input.name,
                                        input.minimum + place * (input.maximum - input.minimum));
                           },
                           {esm::EditKind::Input, region, 0});
}

/// ms, from a slider's move to the first frame that is computed by what it comes to.
double timeToSee(esm::MainWindow& window, const WindowWatch& watch, int move) {
    const auto start = std::chrono::steady_clock::now();
    moveSlider(window, move);
    const int number = window.preview().projectCount();
    waitFor("a frame by new parameters", [&] { return watch.project() >= number; });
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void print(const char* what, const Times& times) {
    std::printf("  %-44s median %6.1f   99 %% %6.1f   latest %6.1f ms\n", what, share(times, 0.5),
                share(times, 0.99), share(times, 1));
}

void printAll(const char* phase, const WindowWatch& watch) {
    std::printf(" %s\n", phase);
    print("an answer of the window", watch.answers());
    print("between computed frames", watch.frameGaps());
    print("between pictures", watch.pictureGaps());
}

void measure(std::size_t nodes, Tissue tissue) {
    esm::MainWindow window(ballOf(nodes, tissue));
    window.show();
    window.preview().setGentleMotion(true);
    window.preview().setPlaying(true);
    waitFor("motion", [&] { return window.preview().status().realTimeFactor > 0; });
    wait(2000);
    const esm::PreviewStatus status = window.preview().status();
    std::printf("%zu nodes, %s in steps of %g ms, %.2g times real time\n",
                window.document().project().network->restPositions.size(), integratorName(*status.integrator),
                1000 * status.timeStep, status.realTimeFactor);
    {
        const WindowWatch watch(window);
        wait(3000);
        printAll("playing", watch);
    }
    {
        const WindowWatch watch(window);
        Times seen;
        for (int move = 0; move < moves; ++move) {
            seen.push_back(timeToSee(window, watch, move));
            window.document().finishGesture();
            wait(betweenMoves);
        }
        printAll("a slider moved now and then", watch);
        print("from the move to its first frame", seen);
    }
    {
        const WindowWatch watch(window);
        for (int tick = 0; tick < ticks; ++tick) {
            moveSlider(window, tick);
            wait(betweenTicks);
        }
        printAll("a slider dragged", watch);
    }
}

/// Takes what the import's dialog proposes, once it was seen for a while, with both repairs.
void acceptImport() {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (!dialog || dialog->objectName() != QLatin1String("importDialog")) return;
    static int ticks = 0;
    const auto choose = [dialog](const char* name) {
        auto* box = dialog->findChild<QAbstractButton*>(QLatin1String(name));
        if (box->isEnabled()) box->click();
    };
    ++ticks;
    if (ticks == 10) choose("closesSlits");
    if (ticks == 20) choose("fillsHoles");
    if (ticks == 40) dialog->accept();
    if (ticks == 40) ticks = 0;
}

void measureImport(const char* file) {
    esm::MainWindow window(ballOf(1000, Tissue::Published));
    window.show();
    wait(2000);
    QTimer accepts;
    QObject::connect(&accepts, &QTimer::timeout, acceptImport);
    accepts.start(100);
    std::printf("%s\n", file);
    const WindowWatch watch(window);
    window.openFiles({std::filesystem::absolute(file)});
    wait(2000);
    print("an answer of the window", watch.answers());
    print("processor time before an answer", watch.busy());
}

} // namespace

int main(int argc, char** argv) {
    QStandardPaths::setTestModeEnabled(true);
    esm::Application application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("esm"));
    QCoreApplication::setApplicationName(QStringLiteral("esm-responsiveness"));
    std::vector<const char*> subjects{"10000", "16000"};
    if (argc > 1) subjects.assign(argv + 1, argv + argc);
    for (const char* subject : subjects) {
        char* end = nullptr;
        const std::size_t nodes = std::strtoull(subject, &end, 10);
        if (*end != '\0') {
            measureImport(subject);
            continue;
        }
        for (const Tissue tissue : {Tissue::Published, Tissue::WeaklyDamped})
            measure(nodes, tissue);
    }
    return 0;
}
