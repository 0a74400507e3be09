#include "app/editor/window/export_controller.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/export_dialog.h"
#include "app/editor/dialogs/long_work.h"
#include "app/editor/dialogs/open_dialog.h"
#include "app/editor/dialogs/save_dialog.h"
#include "app/editor/document/file_memory.h"
#include "app/editor/workers/poke_test.h"
#include "core/offscreen/preview_picture.h"

#include <algorithm>

namespace esm {

namespace {

/// One line of the list of types in the export dialog.
struct ExportKind {
    const Exporter* exporter;
    QString title;
    PictureEncoding pictures;
};

/// Folders take their pictures as they are: their files can be packed by anyone.
std::vector<ExportKind> exportKinds() {
    std::vector<ExportKind> kinds;
    for (const Exporter& exporter : exporters()) {
        const QString title = QString::fromStdString(exporter.title);
        kinds.push_back({&exporter, title, {}});
        if (exporter.holdsPictures && !exporter.isFolder)
            kinds.push_back(
                {&exporter, QObject::tr("%1, texture as JPEG").arg(title), {PictureFormat::Jpeg}});
    }
    return kinds;
}

} // namespace

ExportController::ExportController(QWidget& window, Document& document)
    : QObject(&window), m_window(window), m_document(document) {}

void ExportController::choose() {
    const std::vector<ExportKind> kinds = exportKinds();
    QStringList filters, endings;
    for (const ExportKind& kind : kinds) {
        endings.append(QString::fromStdString(kind.exporter->ending));
        filters.append(QStringLiteral("%1 (*%2)").arg(kind.title, endings.back()));
    }
    const NewFile asked =
        fileForOthers(m_document, tr("Export"), filters.join(QStringLiteral(";;")), endings);
    const auto file = ask(m_window, [&] { return chooseNewFileAndKind(&m_window, asked); });
    if (!file) return;
    rememberFolder(FileKind::Package, file->path);
    exportTo(file->path, kinds.at(static_cast<std::size_t>(std::max(file->filter, 0))).pictures);
}

/// The recorded pull where the project's own scene is another, or else that scene.
TriedMotion ExportController::triedMotion(const Handover& handover) const {
    if (m_poke && m_poke->poke())
        if (auto pulled = sceneOfPull(*m_poke->poke(), handover.project, handover.tissue);
            pulled && *pulled != handover.project.scene)
            return {std::move(*pulled), tr("the recorded pull")};
    return {handover.project.scene, tr("the project's scene")};
}

std::optional<EngineSettings> ExportController::askedSettings(const Handover& handover,
                                                              const Exporter& exporter) {
    if (!exporter.isStepped && differencesOf(handover, exporter).list.empty()) return EngineSettings{};
    TriedMotion tried = exporter.canBeTried ? triedMotion(handover) : TriedMotion{};
    ExportDialog dialog(exporter, handover, std::move(tried), &m_window);
    if (ask(m_window, [&] { return dialog.exec(); }) != QDialog::Accepted) return std::nullopt;
    return dialog.settings();
}

void ExportController::exportTo(const std::filesystem::path& file, const PictureEncoding& pictures) {
    attempt(&m_window, tr("The organ was not exported"), [&] {
        const Exporter& exporter = exporterFor(file);
        requireFree(file, exporter);
        const Project project = m_document.project();
        const Handover handover = computeLong(
            &m_window, tr("Looking at the organ"),
            [&](const Progress& progress) { return handoverFor(file, project, progress); },
            Cancelling::Offered);
        const auto settings = askedSettings(handover, exporter);
        if (!settings) return;
        runLongWork(
            &m_window, tr("Exporting %1").arg(fileName(file)),
            [&](const Progress& progress) {
                exportHandover(handover, exporter, file, {progress, previewPicture, pictures, *settings});
            },
            Cancelling::UntilDone);
        emit exported(QString::fromStdString(file.string()));
    });
}

} // namespace esm
