#include "app/editor/dialogs/lens_files.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/open_dialog.h"
#include "app/editor/dialogs/save_dialog.h"
#include "core/exchange/project/preparation_json.h"

#include <QDir>

namespace esm {

namespace {

QString lensFilter() {
    return QObject::tr("Lenses (*.json)");
}

} // namespace

void openLens(QWidget* window, const std::function<void(const Lens&)>& use) {
    const auto file = chooseFile(window, QObject::tr("Load lens"), FileKind::Lens, lensFilter());
    if (!file) return;
    attempt(window, QObject::tr("The lens cannot be loaded"), [&] { use(readLensFile(*file)); });
}

void saveLens(QWidget* window, const QString& suggestedName, const Lens& lens) {
    const NewFile asked{QObject::tr("Save lens"),
                        QDir(startFolder(FileKind::Lens, std::nullopt)).filePath(suggestedName),
                        lensFilter(),
                        {QStringLiteral(".json")}};
    const auto file = ask(*window, [&] { return chooseNewFile(window, asked); });
    if (!file) return;
    rememberFolder(FileKind::Lens, *file);
    attempt(window, QObject::tr("The lens cannot be saved"), [&] { writeLensFile(lens, *file); });
}

} // namespace esm
