#include "app/editor/window/import_controller.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/long_work.h"
#include "app/editor/dialogs/open_dialog.h"
#include "core/solid/filled_body.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <cmath>
#include <utility>

namespace esm {

namespace {

/// A file's surface as it is written there, and as it would be imported.
struct ReadSurface {
    MeshSource source;
    std::shared_ptr<const PolygonSoup> soup;
    std::shared_ptr<const ImportedSurface> found;
};

ReadSurface readSurface(const std::filesystem::path& file, const Progress& progress) {
    ProgressParts parts(progress);
    ReadSurface read;
    read.soup = std::make_shared<const PolygonSoup>(readMeshFile(file, parts.next(0.4)));
    read.source = meshSourceOf(file, parts.next(0.1));
    read.found = std::make_shared<const ImportedSurface>(importedSurface(*read.soup, {}, parts.rest()));
    return read;
}

/// Times the nodes that were promised: more come of a thin body, whatever the spacing.
constexpr double mostOfWanted = 5;

/// A wall as it is asked for; of a solid organ a lattice of the usual kind: others are chosen once it stands
/// in the window.
Detail detailFor(const TriangleMesh& mesh, Detail detail, const Progress& progress) {
    detail.isEven = true;
    if (detail.kind != Detail::Kind::Filled || detail.filling) return detail;
    const auto wanted = static_cast<double>(std::exchange(detail.nodes, 0));
    detail.filling = fillingOf(mesh, LatticeFilling().kind, wanted);
    const double nodes = estimateLattice(mesh, *detail.filling, progress).nodes;
    if (nodes > mostOfWanted * wanted)
        throw InvalidModel(
            "what the surface encloses is thin, as a wall is, and would take about " +
            roundedText(std::round(nodes / 1000)) +
            " thousand nodes to fill; import it hollow, then Model → Inside… shows what fills it");
    return detail;
}

Project organOf(const PolygonSoup& soup, const MeshSource& source, const ImportChoice& choice,
                const Progress& progress) {
    ProgressParts parts(progress);
    PolygonSoup metres = soup;
    convertToMetres(metres, choice.unit, choice.up);
    RepairedMesh mesh = repair(metres, repairOptions(choice), parts.next(0.5));
    const Detail detail = detailFor(mesh.mesh, choice.body.detail, parts.next(0.1));
    Project project = makeProject(std::filesystem::path(source.file).stem().string(), std::move(mesh),
                                  std::nullopt, detail, parts.rest());
    project.source = source;
    project.base.resistsBending = choice.body.resistsBending;
    return project;
}

} // namespace

ImportController::ImportController(QWidget& window, Document& document, std::function<bool()> mayLeaveProject)
    : QObject(&window), m_window(window), m_document(document),
      m_mayLeaveProject(std::move(mayLeaveProject)) {}

void ImportController::chooseMesh() {
    const QString filter = fileFilter(tr("Surfaces"), meshFileEndings()) + tr(";;All files (*)");
    const auto file =
        chooseFile(&m_window, tr("Import organ surface"), FileKind::Mesh, filter, m_document.path());
    if (file) importMesh(*file);
}

void ImportController::importMesh(const std::filesystem::path& file) {
    attempt(&m_window, tr("The surface cannot be imported"), [&] {
        const QString title = tr("Importing %1").arg(fileName(file));
        const ReadSurface read = computeLong(
            &m_window, title, [&](const Progress& progress) { return readSurface(file, progress); },
            Cancelling::Offered);
        ImportDialog dialog(fileName(file), read.soup, read.found, &m_window);
        bool mayLeave = false;
        while (ask(m_window, [&] { return dialog.exec(); }) == QDialog::Accepted) {
            mayLeave = mayLeave || m_mayLeaveProject();
            if (!mayLeave || importAs(dialog.choice(), *read.soup, read.source, file)) break;
        }
        runLongWork(&m_window, tr("Closing the import"), [&](const Progress&) { dialog.stopWork(); });
    });
}

bool ImportController::importAs(const ImportChoice& choice, const PolygonSoup& soup, const MeshSource& source,
                                const std::filesystem::path& file) {
    return attempt(&m_window, tr("The surface cannot be imported so"), [&] {
        Project project = computeLong(
            &m_window, tr("Importing %1").arg(fileName(file)),
            [&](const Progress& progress) { return organOf(soup, source, choice, progress); },
            Cancelling::Offered);
        m_document.replace(std::move(project), std::nullopt, Origin::Unsaved,
                           {{}, std::filesystem::path(file).replace_extension(".esm")});
        emit imported(file);
    });
}

} // namespace esm
