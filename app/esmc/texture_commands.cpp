#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/named_layer.h"
#include "app/esmc/opened_file.h"
#include "app/esmc/preparation_options.h"
#include "app/esmc/project_output.h"
#include "core/authoring/packing.h"
#include "core/authoring/photo_replacement.h"
#include "core/exchange/project/project_file.h"
#include "core/exchange/project/projector_file.h"
#include "core/support/errors.h"
#include "core/support/joined.h"
#include "core/texture/atlas/distortion.h"
#include "core/texture/atlas/own_layout.h"
#include "core/texture/layers/composite.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace esm {

namespace {

namespace fs = std::filesystem;

struct PackOptions {
    std::string project, output;
    AtlasOptions atlas;
};

void declarePack(CLI::App& command, PackOptions& options) {
    command.add_option("project", options.project, "Project to read (.esm)")->required();
    command.add_option("-o,--output", options.output, "Project to write; may be the one that is read")
        ->required()
        ->check(writtenAs(".esm"));
    // The packer says which of these the mesh can do with.
    command.add_option("--size", options.atlas.size, "Width and height of a page, pixels (2048)")
        ->transform(wholeNumber());
    command.add_option("--pages", options.atlas.pages, "Pages (1)")->transform(wholeNumber());
    command.add_option("--gap", options.atlas.gap, "Pixels between any two patches (2)")
        ->transform(wholeNumber());
    command
        .add_option("--texels-per-metre", options.atlas.texelsPerMetre,
                    "As many pages as so many texels per metre take (default: as many as --pages hold)")
        ->check(numberWithin(0, texture_limits::mostTexelsPerMetre));
    addChoice(command, "--layout", options.atlas.layout,
              {{wordOf(AtlasLayout::Rows), AtlasLayout::Rows},
               {wordOf(AtlasLayout::MatchedRows), AtlasLayout::MatchedRows},
               {wordOf(AtlasLayout::UnfoldedGroups), AtlasLayout::UnfoldedGroups},
               {wordOf(AtlasLayout::Charts), AtlasLayout::Charts},
               {wordOf(AtlasLayout::Own), AtlasLayout::Own}},
              "How triangles are laid side by side (matched_rows); own: as the mesh's file has them");
}

/// @throws UsageError where no surface could be laid out like that, InvalidModel where this one cannot;
/// either says what fits
void packAs(const AtlasOptions& options, Project& project) {
    if (options.layout == AtlasLayout::Own && (options.pages != 1 || options.texelsPerMetre > 0))
        throw UsageError(
            "--layout own takes one page at the density that the mesh brought: leave out --pages "
            "and --texels-per-metre");
    project.texture.atlas = options;
    try {
        pack(project);
    } catch (const InvalidModel& problem) {
        if (!validate(options).empty()) throw UsageError(problem.what());
        if (options.layout != AtlasLayout::Own) throw;
        throw InvalidModel(std::string(problem.what()) +
                           "; --layout matched_rows packs the surface anew, without its own coordinates");
    }
    project.texture.atlas = project.atlas->options;
}

Json spreadInJson(const DistortionSpread& spread) {
    return {{"mean", spread.mean}, {"percentile_95", spread.percentile95}, {"worst", spread.worst}};
}

std::string spreadInWords(const char* what, const DistortionSpread& spread, const char* against) {
    return what + (" " + inText(spread.mean)) + " times " + against + " on average, up to " +
           inText(spread.percentile95) + " times on 95 % of the surface, " + inText(spread.worst) +
           " times at the worst";
}

void addDistortion(Report& report, const Distortion& distortion) {
    report.json["distortion"] = {{"angle", spreadInJson(distortion.angle)},
                                 {"area", spreadInJson(distortion.area)},
                                 {"flipped", distortion.flipped},
                                 {"collapsed", distortion.collapsed}};
    constexpr double unseen = 1.0005; // rounded to three digits, nothing
    if (distortion.angle.worst < unseen && distortion.area.worst < unseen) {
        report.text.emplace_back("no triangle is distorted");
    } else {
        report.text.push_back(
            spreadInWords("triangles are stretched one way", distortion.angle, "as much as the other"));
        report.text.push_back(spreadInWords("their density is", distortion.area, "off the mean"));
    }
    if (distortion.flipped > 0)
        report.text.push_back(counted(distortion.flipped, "triangle") + " folded over");
    if (distortion.collapsed > 0)
        report.text.push_back(counted(distortion.collapsed, "triangle") + " without an area in the texture");
}

Report runPack(const PackOptions& options, Context& context) {
    context.subject = options.project;
    const ProjectOutput output(options.output);
    Project project = openedProject(options.project, context);
    packAs(options.atlas, project);
    output.save(project);
    const Atlas& atlas = *project.atlas;
    const double seams = seamShare(*project.mesh, atlas), seamLength = seamLengthShare(*project.mesh, atlas);
    Report report;
    report.json = {{"utilisation", atlas.utilisation},
                   {"texels_per_metre", atlas.texelsPerMetre},
                   {"pages", atlas.options.pages},
                   {"gap", atlas.options.gap},
                   {"size", atlas.options.size},
                   {"layout", wordOf(atlas.options.layout)},
                   {"seam_share", seams},
                   {"seam_length_share", seamLength}};
    report.text.push_back(counted(static_cast<std::size_t>(atlas.options.pages), "page") + " of " +
                          std::to_string(atlas.options.size) + " × " + std::to_string(atlas.options.size) +
                          " pixels, " + inText(100 * atlas.utilisation) + " % used, " +
                          inText(atlas.texelsPerMetre / 1000) + " pixels per mm");
    report.text.push_back(inText(100 * seams) + " % of the edges are seams, " + inText(100 * seamLength) +
                          " % of their length");
    addDistortion(report, distortionOf(*project.mesh, atlas));
    addWritten(report, options.output);
    if (atlas.options.layout == AtlasLayout::Own) addWarnings(report, ownLayoutWarnings(*project.mesh));
    return report;
}

struct PhotoOptions {
    std::string project, output, photo, projector, name;
    double blend = TextureLayer().blendPixels;
    Blending blending = Blending::Normal;
    PreparationOptions preparation;
};

void declarePhoto(CLI::App& command, PhotoOptions& options) {
    command.add_option("project", options.project, "Project to read (.esm)")->required();
    command.add_option("-o,--output", options.output, "Project to write; may be the one that is read")
        ->required()
        ->check(writtenAs(".esm"));
    command.add_option("--photo", options.photo, "Photograph (PNG, JPEG, BMP or TIFF)")->required();
    command.add_option("--projector", options.projector, "Where the photograph is projected from (.json)")
        ->required();
    command
        .add_option(
            "--blend", options.blend,
            "Pixels of the photograph over which it fades in from its border, from what is left out of it "
            "and from outlines (24)")
        ->check(nonNegativeNumber());
    addChoice(command, "--blending", options.blending, "How it mixes with what lies beneath (normal)");
    command.add_option("--name", options.name, "The layer's name (default: the photograph's)");
    declarePreparation(command, options.preparation);
}

/// What shows the photograph otherwise than its taker saw it.
std::vector<std::string> placingWarnings(const TextureLayer& layer) {
    std::vector<std::string> warnings;
    const Image& photo = layer.photo->image;
    const double stretch =
        layer.projector.width / layer.projector.height * photo.height / static_cast<double>(photo.width);
    if (layer.projector.kind == ProjectorKind::Parallel && std::abs(std::log(stretch)) > std::log(1.02))
        warnings.push_back("the projector's width and height stretch the photo of " +
                           std::to_string(photo.width) + " × " + std::to_string(photo.height) +
                           " pixels to " + inText(stretch) + " times its proportion");
    if (layer.blendPixels > std::min(photo.width, photo.height) / 2.0)
        warnings.emplace_back(
            "the border fades in over more than half of the photo: nothing of it shows in full");
    return warnings;
}

/// @param remarks further warnings
Report describe(const TextureLayer& layer, const LayerCoverage& covered,
                const std::vector<std::string>& remarks = {}) {
    Report report;
    report.json = {{"layer", layer.name}, {"texels", covered.texels}, {"triangles", covered.triangles}};
    report.text.push_back("photo " + layer.name + ": " + counted(covered.triangles, "triangle") + ", " +
                          counted(covered.texels, "pixel") + " of texture");
    std::vector<std::string> warnings = placingWarnings(layer);
    const std::vector<std::string> doubts = warningsOf(layer.photo->image, layer.preparation);
    warnings.insert(warnings.end(), doubts.begin(), doubts.end());
    warnings.insert(warnings.end(), remarks.begin(), remarks.end());
    if (covered.triangles == 0)
        warnings.emplace_back("the photo meets no triangle: check the projector's place, direction and size");
    addWarnings(report, warnings);
    return report;
}

Report runPhoto(const PhotoOptions& options, Context& context) {
    context.subject = options.project;
    const ProjectOutput output(options.output);
    Project project = openedProject(options.project, context);
    TextureLayer layer;
    layer.photo = loadPhoto(options.photo);
    layer.projector = readProjectorFile(options.projector);
    layer.blendPixels = options.blend;
    layer.blending = options.blending;
    layer.name = options.name.empty() ? fs::path(options.photo).stem().string() : options.name;
    context.subject = options.photo;
    const Report found = prepareLayer(project, layer, options.preparation);
    context.subject = options.project;
    packIfNeeded(project);
    const LayerCoverage covered = coverage(*project.mesh, *project.atlas, layer);
    project.layers.push_back(layer);
    output.save(project);
    Report report = describe(layer, covered);
    report.json.update(found.json);
    report.text.insert(report.text.end(), found.text.begin(), found.text.end());
    addWritten(report, options.output);
    return report;
}

struct ReplaceOptions {
    std::string project, output, layer, photo;
};

void declareReplace(CLI::App& command, ReplaceOptions& options) {
    command.add_option("project", options.project, "Project to read (.esm)")->required();
    command.add_option("-o,--output", options.output, "Project to write; may be the one that is read")
        ->required()
        ->check(writtenAs(".esm"));
    command.add_option("--layer", options.layer, "Name of the photograph's layer")->required();
    command.add_option("--photo", options.photo, "Photograph to take its place (PNG, JPEG, BMP or TIFF)")
        ->required();
}

Report runReplace(const ReplaceOptions& options, Context& context) {
    context.subject = options.project;
    const ProjectOutput output(options.output);
    Project project = openedProject(options.project, context);
    TextureLayer& layer = layerNamed(project, options.layer, LayersMeant::Photographs);
    context.subject = options.photo;
    const TextureLayer before = std::exchange(layer, withPhoto(layer, loadPhoto(options.photo)));
    context.subject = options.project;
    packIfNeeded(project);
    const LayerCoverage covered = coverage(*project.mesh, *project.atlas, layer);
    output.save(project);
    Report report = describe(layer, covered, replacementRemarks(before, layer));
    report.json["same_shape"] = haveOneShape(before.photo->image, layer.photo->image);
    addWritten(report, options.output);
    return report;
}

} // namespace

void addTextureCommands(CLI::App& app, Context& context) {
    CLI::App* texture = app.add_subcommand("texture", "Photographs on the organ's surface");
    texture->require_subcommand(1);
    addCommand(
        *texture, context,
        Command<PackOptions>{"pack", "Give every triangle its place in the texture", declarePack, runPack});
    addCommand(*texture, context,
               Command<PhotoOptions>{"photo", "Lay a photograph on the organ", declarePhoto, runPhoto});
    addCommand(*texture, context,
               Command<ReplaceOptions>{"replace", "Lay another photograph in the place of one",
                                       declareReplace, runReplace});
    addFitCommand(*texture, context);
    addFinishCommand(*texture, context);
    addBakeCommand(*texture, context);
}

} // namespace esm
