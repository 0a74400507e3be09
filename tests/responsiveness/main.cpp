// Measures how a window keeps up while its tissue plays and is edited: how soon it answers, how far frames
// lie apart, and how long a slider's move takes to be seen; how many pictures a second a large organ is
// turned by, or a photo is moved by on it; how soon a stroke is seen on a large page; and of mesh files, how
// it answers while they are imported. In a virtual display it draws by software.
//   responsiveness [turn|photo|stroke|colours|NODES|MESH…]   all but meshes, 10000 and 16000 nodes unless
//   given

#include "app/editor/document/document.h"
#include "app/editor/document/edit_kind.h"
#include "app/editor/window/application.h"
#include "app/editor/workers/preview.h"
#include "tests/responsiveness/organ.h"
#include "tests/responsiveness/window_watch.h"
#include "widgets/view/organ_view.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDeadlineTimer>
#include <QDialog>
#include <QEventLoop>
#include <QSettings>
#include <QStandardPaths>
#include <QTimer>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <string_view>
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

/// Coloured by strain while it plays: every frame has colours of its own.
void measureColours(std::size_t nodes) {
    esm::MainWindow window(ballOf(nodes, Tissue::Published));
    window.show();
    window.preview().setGentleMotion(true);
    window.preview().setPlaying(true);
    waitFor("motion", [&] { return window.preview().status().realTimeFactor > 0; });
    std::printf("%zu nodes, playing\n", window.document().project().network->restPositions.size());
    for (QAction* colouring : window.windowActions().colourings->actions()) {
        colouring->trigger();
        wait(1000);
        const WindowWatch watch(window);
        wait(3000);
        printAll(("coloured by " + colouring->objectName()).toUtf8().constData(), watch);
    }
}

/// About the vertical, a picture asked for as often as a mouse moves. What the processors did for each
/// picture says more than its time where other programs are at work.
void turn(esm::MainWindow& window, const char* phase) {
    wait(1500);
    const WindowWatch watch(window);
    const std::clock_t start = std::clock();
    for (int tick = 0; tick < ticks; ++tick) {
        window.view().setCamera(esm::orbited(window.view().camera(), 0.02, 0));
        wait(betweenTicks);
    }
    const double computed = 1000.0 * double(std::clock() - start) / CLOCKS_PER_SEC;
    printAll(phase, watch);
    std::printf("  %.1f pictures a second by the median; %.1f ms of all processors for each\n",
                1000 / std::max(share(watch.pictureGaps(), 0.5), 1e-3),
                computed / double(std::max<std::size_t>(watch.pictureGaps().size(), 1)));
}

/// A window with a view of 1280 x 800 pixels, without panels.
void showLargeView(esm::MainWindow& window) {
    window.windowActions().showLeft->setChecked(false);
    window.windowActions().showRight->setChecked(false);
    window.show();
    window.resize(window.size() + QSize(1280, 800) - window.view().size());
    window.preview().setPlaying(false);
    wait(500);
    std::printf("%zu triangles, a view of %d x %d pixels\n",
                window.document().project().mesh->triangles.size(), window.view().width(),
                window.view().height());
}

void measureTurning(std::size_t triangles, std::size_t nodes) {
    esm::MainWindow window(drawnBallOf(triangles, nodes));
    showLargeView(window);
    turn(window, "turned");
    window.preview().setGentleMotion(true);
    window.preview().setPlaying(true);
    waitFor("motion", [&] { return window.preview().status().realTimeFactor > 0; });
    turn(window, "turned while it plays");
}

/// The projector of a photo that is blended in bands and masked by a stroke, moved as often as a mouse moves.
void measurePhoto(std::size_t triangles) {
    esm::MainWindow window(photographedBallOf(triangles, 3, 4096));
    showLargeView(window);
    window.windowActions().texture->setChecked(true);
    waitFor("photos", [&] { return window.view().scene().texturePages != nullptr; });
    wait(1000);
    const esm::LayerId moved{3};
    const auto move = [&](int tick) {
        window.document().edit(QStringLiteral("projector"),
                               [&](esm::Project& project) {
                                   esm::Pose& pose = partOf(project.layers, moved).projector.pose;
                                   pose.translation().x() += tick % 40 < 20 ? 2e-4 : -2e-4;
                               },
                               {esm::EditKind::ProjectorDrag, moved, 0});
    };
    for (int tick = 0; tick < 40; ++tick) {
        move(tick);
        wait(betweenTicks);
    }
    const WindowWatch watch(window);
    const std::clock_t start = std::clock();
    for (int tick = 0; tick < ticks; ++tick) {
        move(tick);
        wait(betweenTicks);
    }
    const double computed = 1000.0 * double(std::clock() - start) / CLOCKS_PER_SEC;
    printAll("a projector moved", watch);
    std::printf("  %.1f pictures a second by the median; %.1f ms of all processors for each\n",
                1000 / std::max(share(watch.pictureGaps(), 0.5), 1e-3),
                computed / double(std::max<std::size_t>(watch.pictureGaps().size(), 1)));
}

/// Dabs of paint, each until the page that has it is in the view's picture.
void measureStrokes(std::size_t triangles, int pageSize) {
    esm::MainWindow window(photographedBallOf(triangles, 2, pageSize));
    showLargeView(window);
    window.windowActions().texture->setChecked(true);
    waitFor("photos", [&] { return window.view().scene().texturePages != nullptr; });
    wait(3000);
    int pictures = 0;
    QObject::connect(&window.view(), &esm::OrganView::drawn, &window, [&] { ++pictures; });
    Times seen, computed;
    for (int i = 0; i < moves; ++i) {
        const auto before = window.view().scene().texturePages;
        esm::BrushStroke stroke;
        stroke.kind = esm::BrushKind::Colour;
        stroke.radius = 0.004;
        stroke.colour = {20, 200, std::uint8_t(10 * i)};
        const double angle = 0.05 * i;
        const Eigen::Vector3d normal(std::sin(angle), 0, std::cos(angle));
        stroke.path = {{0.06 * normal, normal}};
        const auto start = std::chrono::steady_clock::now();
        const std::clock_t started = std::clock();
        window.document().edit(QStringLiteral("stroke"), [&](esm::Project& project) {
            project.layers.back().strokes.push_back(std::make_shared<const esm::BrushStroke>(stroke));
        });
        waitFor("the page", [&] { return window.view().scene().texturePages != before; });
        pictures = 0;
        waitFor("its picture", [&] { return pictures > 0; });
        computed.push_back(1000.0 * double(std::clock() - started) / CLOCKS_PER_SEC);
        seen.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
        wait(300);
    }
    std::printf(" strokes on a page of %d x %d texels\n", pageSize, pageSize);
    print("from a stroke to its picture", seen);
    print("of all processors meanwhile", computed);
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

void measureImport(const std::string& file) {
    esm::MainWindow window(ballOf(1000, Tissue::Published));
    window.show();
    wait(2000);
    QTimer accepts;
    QObject::connect(&accepts, &QTimer::timeout, acceptImport);
    accepts.start(100);
    std::printf("%s\n", file.c_str());
    const WindowWatch watch(window);
    window.openFiles({std::filesystem::absolute(file)});
    wait(2000);
    print("an answer of the window", watch.answers());
    print("processor time before an answer", watch.busy());
}

void measureSubject(std::string_view subject) {
    if (subject == "turn") return measureTurning(200000, 10000);
    if (subject == "photo") return measurePhoto(60000);
    if (subject == "stroke") return measureStrokes(20000, 8192);
    if (subject == "colours") return measureColours(16000);
    std::size_t nodes = 0;
    const char* end = subject.data() + subject.size();
    if (std::from_chars(subject.data(), end, nodes).ptr != end) return measureImport(std::string(subject));
    for (const Tissue tissue : {Tissue::Published, Tissue::WeaklyDamped})
        measure(nodes, tissue);
}

} // namespace

int main(int argc, char** argv) {
    QStandardPaths::setTestModeEnabled(true);
    esm::Application application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("esm"));
    QCoreApplication::setApplicationName(QStringLiteral("esm-responsiveness"));
    std::vector<std::string_view> subjects{"turn", "photo", "stroke", "10000", "16000", "colours"};
    if (argc > 1) subjects.assign(argv + 1, argv + argc);
    for (const std::string_view subject : subjects)
        measureSubject(subject);
    return 0;
}
