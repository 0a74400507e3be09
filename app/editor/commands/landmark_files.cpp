#include "app/editor/commands/landmark_files.h"

#include "app/editor/commands/ask.h"
#include "app/editor/commands/attempt.h"
#include "app/editor/commands/save_dialog.h"
#include "app/editor/document/file_memory.h"
#include "core/exchange/pairs_file.h"

#include <QDir>
#include <QFileDialog>

namespace esm {

namespace {

QString landmarkFolder() {
    return startFolder(FileKind::Landmarks, std::nullopt);
}

QString landmarkFilter() {
    return QObject::tr("Landmarks (*.csv)");
}

} // namespace

void openLandmarks(QWidget* window, const std::function<void(std::vector<LandmarkPair>)>& use) {
    const QString file = ask(*window, [&] {
        return QFileDialog::getOpenFileName(window, QObject::tr("Load landmarks"), landmarkFolder(),
                                            landmarkFilter());
    });
    if (file.isEmpty()) return;
    rememberFolder(FileKind::Landmarks, file.toStdString());
    attempt(window, QObject::tr("The landmarks cannot be loaded"),
            [&] { use(readPairsFile(file.toStdString())); });
}

void saveLandmarks(QWidget* window, const QString& suggestedName, const std::vector<LandmarkPair>& pairs) {
    const NewFile asked{QObject::tr("Save landmarks"),
                        QDir(landmarkFolder()).filePath(suggestedName),
                        landmarkFilter(),
                        {QStringLiteral(".csv")}};
    const auto file = ask(*window, [&] { return chooseNewFile(window, asked); });
    if (!file) return;
    rememberFolder(FileKind::Landmarks, *file);
    attempt(window, QObject::tr("The landmarks cannot be saved"), [&] { writePairsFile(pairs, *file); });
}

} // namespace esm
