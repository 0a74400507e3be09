#include "app/esmc/arguments.h"
#include "app/esmc/bending_option.h"
#include "app/esmc/commands.h"
#include "app/esmc/filling_options.h"
#include "app/esmc/filling_report.h"
#include "app/esmc/model_report.h"
#include "core/authoring/import_unit.h"
#include "core/exchange/meshes/mesh_file.h"
#include "core/geometry/hole_filling.h"
#include "core/support/numbers.h"

namespace esm {

namespace {

struct ImportOptions {
    std::string mesh, output;
    LengthUnit unit = LengthUnit::Metre;
    double weld = 0;   // m
    double close = 0;  // mm
    int fillHoles = 0; // edges
    KeepParts keep = KeepParts::All;
    std::optional<double> mass; // kg; from the surface without
    UpAxis up = UpAxis::Y;
    Detail detail;
    bool isEven = true;
    FillingOptions filling;
    BendingOption bending;
};

Detail requestedDetail(const std::string& given) {
    if (given == "rigid") return {Detail::Kind::Rigid, 0};
    const auto nodes = parseWholeNumber(given, fewestVertices, std::numeric_limits<int>::max());
    if (!nodes)
        throw UsageError("--detail: '" + given + "' is neither a number of nodes, 4 or more, nor rigid");
    return {Detail::Kind::Nodes, static_cast<std::size_t>(*nodes)};
}

int requestedHoleEdges(const std::string& given) {
    const auto edges = parseWholeNumber(given, 0, static_cast<int>(mostHoleEdges));
    if (!edges || *edges == 1 || *edges == 2)
        throw UsageError("--fill-holes: '" + given + "' is neither 0 nor a whole number from 3 to " +
                         std::to_string(mostHoleEdges));
    return *edges;
}

/// Slits are given as people measure them, whatever the file's unit.
void declareRepairs(CLI::App& command, ImportOptions& options) {
    command
        .add_option("--close", options.close,
                    "Stitch open borders no farther apart than MM millimetres of the organ's final size, at "
                    "most a tenth of it (0: none)")
        ->check(nonNegativeNumber())
        ->option_text("MM");
    command
        .add_option_function<std::string>(
            "--fill-holes",
            [&options](const std::string& given) { options.fillHoles = requestedHoleEdges(given); },
            "Fill open borders of at most N edges, 3 to " + std::to_string(mostHoleEdges) +
                " (0: none), once slits are closed")
        ->option_text("N");
}

void declareImport(CLI::App& command, ImportOptions& options) {
    command.add_option("mesh", options.mesh, "Surface: " + joined(meshFileEndings()))->required();
    command.add_option("-o,--output", options.output, "Project to write (.esm)")
        ->required()
        ->check(writtenAs(".esm"));
    addChoice(command, "--unit", options.unit,
              "What a coordinate of the file means: mm, cm or m (the default)");
    command
        .add_option("--weld", options.weld, "Vertices closer than this become one, m (0: only equal ones)")
        ->check(nonNegativeNumber());
    declareRepairs(command, options);
    addChoice(command, "--keep", options.keep,
              Words<KeepParts>{{"all", KeepParts::All}, {"largest", KeepParts::Largest}},
              "Parts to keep: all (the default), or the largest");
    command
        .add_option("--mass", options.mass,
                    "Total mass, kg (default: from the volume, or the area of an open surface)")
        ->check(numberWithin(1 / largestNumber, largestNumber));
    addChoice(command, "--up", options.up,
              "The file's axis that points up: y (the default), z, x, or with minus- where it points down");
    command
        .add_option_function<std::string>(
            "--detail", [&options](const std::string& given) { options.detail = requestedDetail(given); },
            "Nodes simulated under the full drawn surface, 4 or more; or rigid: a few springs that move it "
            "as "
            "one stiff piece (default: every vertex is a node)")
        ->option_text("N|rigid");
    addSpringsChoice(command, options.isEven);
    declareFilling(command, options.filling, "without it the organ is hollow, its surface alone has springs");
    declareBending(command, options.bending);
}

/// @throws UsageError, InvalidModel
Detail detailFor(const ImportOptions& options, const TriangleMesh& mesh) {
    const auto filling = chosenFilling(mesh, options.filling, usualWallThickness);
    if (!filling) {
        Detail detail = options.detail;
        detail.isEven = options.isEven;
        return detail;
    }
    if (options.detail.kind != Detail::Kind::EveryVertex)
        throw UsageError("--fill and --detail exclude each other: the spacing says how many nodes there are");
    return {Detail::Kind::Filled, 0, filling};
}

/// Says which unit was probably meant; empty when the size (m) is one that organs and bodies have.
std::string doubtfulSize(double size, const ImportOptions& options) {
    if (isPlausibleSize(size)) return {};
    const double extent = size / metresPer(options.unit);
    const LengthUnit likely = recommendedUnit(extent, meshFileEnding(options.mesh));
    std::string advice;
    for (const auto& [unit, meant] : fittingUnits(extent))
        advice += std::string(advice.empty() ? "; with" : ", with") + " --unit " + wordOf(unit) +
                  " it would be " + inText(meant) + " m" + (unit == likely ? " (the likeliest)" : "");
    return "the model is " + inText(size) + " m large" +
           (advice.empty() ? ", and no unit makes it an organ's size" : advice);
}

/// @throws InvalidModel in the words of the option
RepairOptions repairOptions(const ImportOptions& options, const PolygonSoup& soup) {
    const double widest = 1000 * widestSlit(boundingBox(soup.vertices).sizes().maxCoeff()); // mm
    if (options.close > widest)
        throw InvalidModel("--close: " + inText(options.close) +
                           " mm is more than a tenth of the surface's size, " + inText(widest) + " mm");
    return {options.weld, options.keep, options.close / 1000, static_cast<std::size_t>(options.fillHoles)};
}

Report runImport(const ImportOptions& options, Context& context) {
    context.subject = options.mesh;
    const ProjectOutput output(options.output);
    PolygonSoup soup = readMeshFile(options.mesh, progressOf(context, "reading"));
    const MeshSource source = meshSourceOf(options.mesh, progressOf(context, "reading"));
    convertToMetres(soup, options.unit, options.up);
    RepairedMesh surface = repair(soup, repairOptions(options, soup), progressOf(context, "repairing"));
    const double size = boundingBox(surface.mesh.vertices).sizes().maxCoeff();
    const std::string doubt = doubtfulSize(size, options);
    if (!doubt.empty()) surface.report.warnings.push_back(doubt);
    const Detail detail = detailFor(options, surface.mesh);
    Project project = makeProject(std::filesystem::path(options.mesh).stem().string(), std::move(surface),
                                  options.mass, detail, progressOf(context, "building"));
    project.source = source;
    setBending(project, options.bending);
    const bool isFilled = detail.filling && !isWall(*detail.filling);
    const NarrowCrossings crossings = isFilled ? narrowCrossings(*project.mesh, *detail.filling,
                                                                 progressOf(context, "looking for crossings"))
                                               : NarrowCrossings{};
    Report report = saveAndReport(project, output);
    if (isFilled) addCrossings(report, crossings);
    return report;
}

} // namespace

void addImportCommand(CLI::App& app, Context& context) {
    addCommand(app, context,
               Command<ImportOptions>{"import", "Make a project of a surface mesh, repairing it",
                                      declareImport, runImport});
}

} // namespace esm
