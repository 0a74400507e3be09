#include "app/editor/window/application.h"
#include "app/editor/window/main_window.h"
#include "app/editor/window/theme.h"
#include "core/samples/samples.h"

#include <QCommandLineParser>

#include <csignal>
#include <future>

namespace {

/// Reads the command line without a window, so that --help and --version need no display; they end the
/// program here.
QStringList readCommandLine(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("esm"));
    QCoreApplication::setApplicationVersion(QStringLiteral(ESM_VERSION));
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Authors deformable organ models for surgical simulators."));
    parser.addPositionalArgument(QStringLiteral("FILE"),
                                 QStringLiteral("a project, an organ's surface to import, or a photo to lay "
                                                "on it, one after the other; without any, a sample organ"),
                                 QStringLiteral("[FILE…]"));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.process(application);
    return parser.positionalArguments();
}

} // namespace

int main(int argc, char** argv) {
    // A limit on file sizes then shows as a write that fails, which is told.
    std::signal(SIGXFSZ, SIG_IGN);
    const QStringList files = readCommandLine(argc, argv);
    // Made while Qt finds its display, fonts and theme, which takes as long.
    auto sample = std::async(std::launch::async, [] { return esm::makeSample("liver"); });

    QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
    esm::Application application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("esm"));
    QCoreApplication::setApplicationName(QStringLiteral("esm"));
    esm::applyTheme(application, esm::Theme::Dark);
    esm::MainWindow window(sample.get());
    window.restore();
    window.show();
    std::vector<std::filesystem::path> paths;
    for (const QString& file : files)
        paths.emplace_back(file.toStdString());
    window.start(paths);
    return esm::Application::exec();
}
