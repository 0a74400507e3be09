#include "app/editor/dialogs/fuzzy_files.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/save_dialog.h"
#include "app/editor/document/file_memory.h"
#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/support/file_io.h"

#include <QDir>
#include <QFileDialog>

namespace esm {

namespace {

QString fuzzyFolder() {
    return startFolder(FileKind::FuzzySystem, std::nullopt);
}

/// A system's name may hold what no file's name may.
QString suggestedFileName(const FuzzySystem& system) {
    QString name = QString::fromStdString(system.name).simplified();
    for (QChar& letter : name)
        if (QStringLiteral("/\\:*?\"<>|").contains(letter)) letter = '_';
    return name.isEmpty() ? QObject::tr("fuzzy system") : name;
}

} // namespace

void openFuzzySystem(QWidget* window,
                     const std::function<void(const std::shared_ptr<const FuzzySystem>&)>& use) {
    const QString file = ask(*window, [&] {
        return QFileDialog::getOpenFileName(window, QObject::tr("Open fuzzy system"), fuzzyFolder(),
                                            QObject::tr("Fuzzy systems (*.json *.fcl *.fll)"));
    });
    if (file.isEmpty()) return;
    rememberFolder(FileKind::FuzzySystem, file.toStdString());
    std::vector<std::string> warnings;
    const bool isOpen = attempt(window, QObject::tr("The fuzzy system cannot be opened"), [&] {
        ImportedFuzzySystem imported = importFuzzyFile(file.toStdString());
        warnings = std::move(imported.warnings);
        use(std::make_shared<const FuzzySystem>(std::move(imported.system)));
    });
    if (isOpen) tell(window, QObject::tr("Not all of the file was taken as it stands there"), warnings);
}

void saveFuzzySystem(QWidget* window, const FuzzySystem& system) {
    const NewFile asked{QObject::tr("Save fuzzy system"),
                        QDir(fuzzyFolder()).filePath(suggestedFileName(system)),
                        QObject::tr("JSON (*.json);;Fuzzy Control Language, IEC 61131-7 (*.fcl);;"
                                    "FuzzyLite Language (*.fll)"),
                        {QStringLiteral(".json"), QStringLiteral(".fcl"), QStringLiteral(".fll")}};
    const auto file = ask(*window, [&] { return chooseNewFile(window, asked); });
    if (!file) return;
    rememberFolder(FileKind::FuzzySystem, *file);
    ExportedFuzzySystem exported;
    const bool isSaved = attempt(window, QObject::tr("The fuzzy system cannot be saved"), [&] {
        exported = exportFuzzySystem(system, *file);
        writeFileAtomically(*file, exported.text);
    });
    if (isSaved)
        tell(window, QObject::tr("Saved; not all of it can be said in this language"), exported.warnings);
}

} // namespace esm
