#include "app/editor/dialogs/landmark_files.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/open_dialog.h"
#include "app/editor/dialogs/save_dialog.h"
#include "core/exchange/project/pairs_file.h"

#include <QDir>

namespace esm {

namespace {

QString landmarkFilter() {
    return QObject::tr("Landmarks (*.csv)");
}

} // namespace

void openLandmarks(QWidget* window, const std::function<void(std::vector<LandmarkPair>)>& use) {
    const auto file =
        chooseFile(window, QObject::tr("Load landmarks"), FileKind::Landmarks, landmarkFilter());
    if (!file) return;
    attempt(window, QObject::tr("The landmarks cannot be loaded"), [&] { use(readPairsFile(*file)); });
}

void saveLandmarks(QWidget* window, const QString& suggestedName, const std::vector<LandmarkPair>& pairs) {
    const NewFile asked{QObject::tr("Save landmarks"),
                        QDir(startFolder(FileKind::Landmarks, std::nullopt)).filePath(suggestedName),
                        landmarkFilter(),
                        {QStringLiteral(".csv")}};
    const auto file = ask(*window, [&] { return chooseNewFile(window, asked); });
    if (!file) return;
    rememberFolder(FileKind::Landmarks, *file);
    attempt(window, QObject::tr("The landmarks cannot be saved"), [&] { writePairsFile(pairs, *file); });
}

} // namespace esm
