#include "app/editor/window/main_window.h"
#include "core/samples/samples.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QTimer>

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
    parser.addPositionalArgument(
        QStringLiteral("FILE"),
        QStringLiteral("a project, or an organ's surface to import; without it a sample organ"),
        QStringLiteral("[FILE]"));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.process(application);
    return parser.positionalArguments();
}

} // namespace

int main(int argc, char** argv) {
    const QStringList files = readCommandLine(argc, argv);
    QSurfaceFormat::setDefaultFormat(esm::viewFormat());

    QApplication application(argc, argv);
    esm::applyTheme(application, esm::Theme::Dark);
    esm::MainWindow window(esm::makeSample("liver"));
    window.show();
    if (!files.isEmpty())
        QTimer::singleShot(0, &window, [&] { window.openFile(files.first().toStdString()); });
    return QApplication::exec();
}
