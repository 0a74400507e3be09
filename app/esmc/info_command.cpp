#include "app/esmc/arguments.h"
#include "app/esmc/bending_option.h"
#include "app/esmc/commands.h"
#include "app/esmc/critical_steps.h"
#include "app/esmc/model_report.h"
#include "app/esmc/opened_file.h"
#include "core/exchange/fields_json.h"
#include "core/model/tissue_digest.h"

#include <set>

namespace esm {

namespace {

struct InfoOptions {
    std::string file;
};

void declareInfo(CLI::App& command, InfoOptions& options) {
    command.add_option("file", options.file, "Project or model package")->required();
}

Json regionInJson(const Region& region, double wallThickness) {
    const RegionTissue tissue = evaluate(region, wallThickness);
    const TissueValues& values = tissue.values;
    return {{"name", region.name},
            {"whole_organ", !region.ellipsoid},
            {"rim", region.rim},
            {"system", region.system ? Json(region.system->name) : Json()},
            {"spring_constant", inJson(values.springConstant)},
            {"viscosity", inJson(values.viscosity)},
            {"youngs_modulus", inJson(youngsModulusOf(values, wallThickness))},
            {"relaxation_time", inJson(relaxationTimeOf(tissue))},
            {"mass", inJson(values.mass)}};
}

std::string regionInText(const Region& region, double wallThickness) {
    const RegionTissue tissue = evaluate(region, wallThickness);
    const TissueValues& values = tissue.values;
    std::vector<std::string> parts;
    if (values.springConstant)
        parts.push_back("spring constant " + inText(*values.springConstant) + " N/m (" +
                        inText(*youngsModulusOf(values, wallThickness) / 1000) + " kPa)");
    if (values.viscosity) parts.push_back("viscosity " + inText(*values.viscosity) + " N·s/m");
    if (const auto time = relaxationTimeOf(tissue))
        parts.push_back("relaxation time " + inText(*time) + " s");
    if (values.mass) parts.push_back("mass " + inText(*values.mass) + " kg");
    if (region.rim > 0 && !parts.empty()) parts.push_back("soft rim " + inText(region.rim) + " m");
    return "region " + region.name + ": " + (parts.empty() ? "changes nothing" : joined(parts));
}

void addRegions(Report& report, const std::vector<Region>& regions, double wallThickness) {
    Json inJson = Json::array();
    std::set<std::string> systems;
    for (const Region& region : regions) {
        inJson.push_back(regionInJson(region, wallThickness));
        report.text.push_back(regionInText(region, wallThickness));
        if (region.system) systems.insert(region.system->name);
    }
    report.json["regions"] = std::move(inJson);
    report.json["fuzzy_systems"] = systems;
}

std::vector<std::string> spareNames(const Project& project) {
    std::vector<std::string> names;
    for (const auto& system : project.spareSystems)
        names.push_back(system->name);
    return names;
}

void addSpareSystems(Report& report, const Project& project) {
    const std::string names = joined(spareNames(project));
    report.json["spare_fuzzy_systems"] = spareNames(project);
    if (!names.empty()) report.text.push_back("fuzzy systems that no region uses: " + names);
}

void addCriticalSteps(Report& report, const TissueModel& tissue) {
    const CriticalSteps steps = criticalSteps(tissue);
    report.json["critical_dt"] = stepsInJson(steps);
    std::vector<std::string> limits;
    limits.reserve(steps.size());
    for (const auto& [integrator, step] : steps)
        limits.push_back(std::string(integratorName(integrator)) + " " + stepInText(step));
    report.text.push_back("largest stable step at any deformation: " + joined(limits));
}

/// The way to step that is recommended.
void addStepping(Report& report, const std::optional<MeasuredStepping>& measured, const TissueModel& tissue) {
    report.json["stepping"] = nullptr;
    if (!measured) return;
    const bool isOutdated = isFromOtherTissue(*measured, tissue);
    const auto& [stepping, error, seconds, digest] = *measured;
    report.json["stepping"] = {{"integrator", integratorName(stepping.integrator)},
                               {"dt", stepping.timeStep},
                               {"precision", wordOf(stepping.precision)},
                               {"error", error},
                               {"wall_per_simulated_s", seconds},
                               {"tissue_changed", isOutdated}};
    report.text.push_back(std::string("recommended: ") + integratorName(stepping.integrator) + " in " +
                          wordOf(stepping.precision) + ", step " + inText(stepping.timeStep) + " s: error " +
                          inText(100 * error) + " % of the motion, " + inText(1 / seconds) +
                          " times real time where it was measured" +
                          (isOutdated ? "; the tissue has changed since" : ""));
}

/// What holds the model and what touches it.
void addHolds(Report& report, const TissueModel& tissue, std::size_t instruments) {
    report.json["fixed"] = tissue.fixedNodes.size();
    report.json["tethers"] = tissue.tethers.size();
    report.json["fillings"] = Json::array();
    for (const Cavity& cavity : tissue.cavities)
        if (cavity.stiffness > 0)
            report.json["fillings"].push_back(writtenFields(FluidFilling{cavity.part, cavity.stiffness}));
    report.json["instrument"] = instruments > 0;
    report.json["instruments"] = instruments;
    report.text.push_back(counted(tissue.fixedNodes.size(), "fixed node") + ", " +
                          counted(tissue.tethers.size(), "tether") +
                          (instruments > 0 ? ", " + counted(instruments, "instrument") : ""));
    for (const Cavity& cavity : tissue.cavities)
        if (cavity.stiffness > 0)
            report.text.push_back("part " + std::to_string(cavity.part) + " is filled with fluid of " +
                                  inText(cavity.stiffness) + " Pa");
}

void addTextures(Report& report, std::size_t pages) {
    report.json["textures"] = pages;
    report.text.push_back(counted(pages, "texture page"));
}

void addPreview(Report& report, const Image& preview) {
    report.json["preview"] = nullptr;
    if (preview.empty()) return;
    report.json["preview"] = {preview.width, preview.height};
    report.text.push_back("a preview picture of " + std::to_string(preview.width) + " × " +
                          std::to_string(preview.height) + " pixels");
}

void addSource(Report& report, const std::optional<MeshSource>& source) {
    report.json["source"] = source ? writtenFields(*source) : Json();
    if (source) report.text.push_back("imported from " + source->file + ", SHA-256 " + source->sha256);
}

/// Who made a package, by its own word.
void addAuthorship(Report& report, const std::optional<Provenance>& provenance) {
    const Authorship authorship = provenance ? provenance->authorship : Authorship();
    report.json["program"] = provenance ? Json(provenance->program) : Json();
    forEachField(fieldsOf<Authorship>, [&](const auto& field) {
        const std::string& statement = authorship.*field.member;
        report.json[field.key] = statement.empty() ? Json() : Json(statement);
        if (!statement.empty()) report.text.push_back(std::string(field.key) + ": " + statement);
    });
}

Report describePackage(const std::filesystem::path& file, Context& context) {
    const ModelPackage package = openedPackage(file, context);
    Report report = modelReport(package);
    report.json["kind"] = "package";
    addRegions(report, package.regions, package.base.wallThickness);
    report.json["wall_thickness"] = package.base.wallThickness;
    report.json["photos"] = Json::array();
    addTextures(report, package.textures.size());
    addPreview(report, package.preview);
    addSource(report, package.provenance ? package.provenance->source : std::nullopt);
    addAuthorship(report, package.provenance);
    addSpringLaw(report, package.tissue.stiffening);
    addBending(report, package.base, *package.tissue.network);
    addHolds(report, package.tissue, false);
    addStepping(report, package.stepping, package.tissue);
    addCriticalSteps(report, package.tissue);
    return report;
}

/// A layer that is only painted has neither file nor size.
Json layerInJson(const TextureLayer& layer) {
    Json json{{"name", layer.name}, {"file", nullptr}, {"size", nullptr}};
    if (layer.photo) {
        json["file"] = layer.photo->fileName;
        json["size"] = {layer.photo->image.width, layer.photo->image.height};
    }
    json["blending"] = wordOf(layer.blending);
    json["strokes"] = layer.strokes.size();
    return json;
}

std::string layerInText(const TextureLayer& layer) {
    std::vector<std::string> parts;
    if (layer.photo) parts.push_back(layer.photo->fileName);
    if (layer.blending != Blending::Normal)
        parts.push_back(std::string(wordOf(layer.blending)) + " blending");
    if (!layer.strokes.empty() || !layer.photo)
        parts.push_back(counted(layer.strokes.size(), "brush stroke"));
    return (layer.photo ? "photo " : "painted layer ") + layer.name + ": " + joined(parts);
}

Report describeProject(const std::filesystem::path& file, Context& context) {
    const Project project = openedProject(file, context);
    Report report = modelReport(project);
    report.json["kind"] = "project";
    addRegions(report, project.regions, project.base.wallThickness);
    report.json["wall_thickness"] = project.base.wallThickness;
    addSpareSystems(report, project);
    Json photos = Json::array();
    for (const TextureLayer& layer : project.layers) {
        photos.push_back(layerInJson(layer));
        report.text.push_back(layerInText(layer));
    }
    report.json["photos"] = std::move(photos);
    addSource(report, project.source);
    addTextures(report, project.atlas ? static_cast<std::size_t>(project.texture.atlas.pages) : 0);
    const TissueModel tissue = evaluateModel(project);
    addSpringLaw(report, tissue.stiffening);
    addBending(report, project.base, *project.network);
    addHolds(report, tissue, project.scene.instruments.size());
    addStepping(report, project.stepping, tissue);
    addCriticalSteps(report, tissue);
    return report;
}

Report runInfo(const InfoOptions& options, Context& context) {
    context.subject = options.file;
    return isModelPackage(options.file) ? describePackage(options.file, context)
                                        : describeProject(options.file, context);
}

} // namespace

void addInfoCommand(CLI::App& app, Context& context) {
    addCommand(app, context,
               Command<InfoOptions>{"info", "Describe a project or a model package", declareInfo, runInfo});
}

} // namespace esm
