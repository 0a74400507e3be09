#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/model_report.h"
#include "core/authoring/import_unit.h"
#include "core/exchange/meshes/mesh_file.h"
#include "core/support/numbers.h"

namespace esm {

namespace {

struct ImportOptions {
    std::string mesh, output;
    LengthUnit unit = LengthUnit::Metre;
    double weld = 0; // m
    KeepParts keep = KeepParts::All;
    std::optional<double> mass; // kg; from the surface without
    UpAxis up = UpAxis::Y;
    Detail detail;
};

Words<LengthUnit> units() {
    Words<LengthUnit> words;
    for (const auto& [unit, word] : wordsOf<LengthUnit>)
        words.emplace_back(word, unit);
    return words;
}

Detail requestedDetail(const std::string& given) {
    if (given == "rigid") return {Detail::Kind::Rigid, 0};
    const auto nodes = parseWholeNumber(given, fewestVertices, std::numeric_limits<int>::max());
    if (!nodes)
        throw UsageError("--detail: '" + given + "' is neither a number of nodes, 4 or more, nor rigid");
    return {Detail::Kind::Nodes, static_cast<std::size_t>(*nodes)};
}

void declareImport(CLI::App& command, ImportOptions& options) {
    command.add_option("mesh", options.mesh, "Surface: " + joined(meshFileEndings()))->required();
    command.add_option("-o,--output", options.output, "Project to write (.esm)")
        ->required()
        ->check(writtenAs(".esm"));
    addChoice(command, "--unit", options.unit, units(),
              "What a coordinate of the file means: mm, cm or m (the default)");
    command
        .add_option("--weld", options.weld, "Vertices closer than this become one, m (0: only equal ones)")
        ->check(nonNegativeNumber());
    addChoice(command, "--keep", options.keep,
              Words<KeepParts>{{"all", KeepParts::All}, {"largest", KeepParts::Largest}},
              "Parts to keep: all (the default), or the largest");
    command
        .add_option("--mass", options.mass,
                    "Total mass, kg (default: from the volume, or the area of an open surface)")
        ->check(numberWithin(1 / largestNumber, largestNumber));
    addChoice(command, "--up", options.up, Words<UpAxis>{{"y", UpAxis::Y}, {"z", UpAxis::Z}},
              "The file's axis that points up: y (the default) or z");
    command
        .add_option_function<std::string>(
            "--detail", [&options](const std::string& given) { options.detail = requestedDetail(given); },
            "Nodes simulated under the full drawn surface, 4 or more; or rigid: a few springs that move it "
            "as "
            "one stiff piece (default: every vertex is a node)")
        ->option_text("N|rigid");
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

Report runImport(const ImportOptions& options, Context& context) {
    context.subject = options.mesh;
    const ProjectOutput output(options.output);
    PolygonSoup soup = readMeshFile(options.mesh, progressOf(context, "reading"));
    convertToMetres(soup, options.unit, options.up);
    RepairedMesh surface = repair(soup, {options.weld, options.keep});
    const double size = boundingBox(surface.mesh.vertices).sizes().maxCoeff();
    const std::string doubt = doubtfulSize(size, options);
    if (!doubt.empty()) surface.report.warnings.push_back(doubt);
    const Project project = makeProject(std::filesystem::path(options.mesh).stem().string(),
                                        std::move(surface), options.mass, options.detail);
    return saveAndReport(project, output);
}

} // namespace

void addImportCommand(CLI::App& app, Context& context) {
    addCommand(app, context,
               Command<ImportOptions>{"import", "Make a project of a surface mesh, repairing it",
                                      declareImport, runImport});
}

} // namespace esm
