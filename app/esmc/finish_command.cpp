#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/named_layer.h"
#include "app/esmc/opened_file.h"
#include "app/esmc/project_output.h"
#include "core/support/errors.h"
#include "core/texture/maps/finish_layers.h"

#include <optional>

namespace esm {

namespace {

struct FinishOptions {
    std::string project, output;
    std::optional<std::string> layer; ///< none: the organ itself
    const FinishPreset* preset = nullptr;
    std::optional<double> roughness, wetness, wetAtHighlights;
    std::optional<double> relief, occlusion; ///< mm
    std::optional<bool> hidesColour;
    bool removes = false;

    bool saysAnything() const {
        return preset || roughness || wetness || wetAtHighlights || relief || hidesColour || occlusion ||
               removes;
    }
};

constexpr double millimetres = 1000; ///< in a metre

void declareFinish(CLI::App& command, FinishOptions& options) {
    command.add_option("project", options.project, "Project to read (.esm)")->required();
    command.add_option("-o,--output", options.output, "Project to write; may be the one that is read")
        ->required()
        ->check(writtenAs(".esm"));
    command.add_option("--layer", options.layer,
                       "Name of the layer that lends it (default: the organ itself)");
    Words<const FinishPreset*> presets;
    for (const FinishPreset& preset : finishPresets)
        presets.emplace_back(preset.word, &preset);
    addChoice(command, "--preset", options.preset, presets, "A kind of tissue, for roughness and wetness");
    command.add_option("--roughness", options.roughness, "Of the tissue, 0 mirrors to 1 dull")
        ->check(numberWithin(0, 1));
    command.add_option("--wetness", options.wetness, "Part that a film of fluid covers, 0 to 1")
        ->check(numberWithin(0, 1));
    command
        .add_option("--wet-at-highlights", options.wetAtHighlights,
                    "How much wetter it is where the photograph has highlights, 0 to 1")
        ->check(numberWithin(0, 1));
    command
        .add_option(
            "--relief", options.relief,
            "How high what is half as bright again as its surroundings in the photograph stands, mm: a guess")
        ->check(numberWithin(0, deepestRelief * millimetres));
    addChoice(command, "--colour", options.hidesColour, {{"shown", false}, {"hidden", true}},
              "Hidden, the layer shows nothing but its finish (shown)");
    command
        .add_option("--occlusion", options.occlusion,
                    "Of the organ: packages and baked pages get a picture of what light from all around its "
                    "folds keep away, by what stands within so many mm; 0: none")
        ->check(numberWithin(0, farthestOcclusion * millimetres));
    CLI::Option* remove =
        command.add_flag("--remove", options.removes, "Takes the layer's or the organ's finish away");
    for (const char* other : {"--preset", "--roughness", "--wetness", "--wet-at-highlights", "--relief",
                              "--colour", "--occlusion"})
        remove->excludes(command.get_option(other));
}

void applySurface(const FinishOptions& options, SurfaceFinish& finish) {
    if (options.preset) finish = options.preset->surface;
    finish.roughness = options.roughness.value_or(finish.roughness);
    finish.wetness = options.wetness.value_or(finish.wetness);
}

void finishOrgan(const FinishOptions& options, Project& project) {
    if (options.wetAtHighlights || options.relief || options.hidesColour)
        throw UsageError("--wet-at-highlights, --relief and --colour are a layer's; name it with --layer");
    TextureSettings& texture = project.texture;
    if (options.removes) return texture.finish.reset();
    if (options.occlusion) texture.occlusionReach = *options.occlusion / millimetres;
    if (!options.preset && !options.roughness && !options.wetness) return;
    if (!texture.finish) texture.finish.emplace();
    applySurface(options, *texture.finish);
}

void finishLayer(const FinishOptions& options, TextureLayer& layer) {
    if (options.occlusion) throw UsageError("--occlusion is the organ's: leave out --layer");
    if (options.removes) return layer.finish.reset();
    if (!layer.finish) layer.finish.emplace();
    applySurface(options, layer.finish->surface);
    layer.finish->wetAtHighlights = options.wetAtHighlights.value_or(layer.finish->wetAtHighlights);
    if (options.relief) layer.finish->relief = *options.relief / millimetres;
    layer.finish->hidesColour = options.hidesColour.value_or(layer.finish->hidesColour);
}

std::string finishText(const std::optional<SurfaceFinish>& finish) {
    if (!finish) return "no finish of its own";
    return "roughness " + inText(finish->roughness) + ", wetness " + inText(finish->wetness);
}

Report runFinish(const FinishOptions& options, Context& context) {
    if (!options.saysAnything())
        throw UsageError("say what finish: --preset, --roughness, --wetness, of a layer also "
                         "--wet-at-highlights, --relief, "
                         "--colour, of the organ --occlusion; or --remove");
    context.subject = options.project;
    const ProjectOutput output(options.output);
    Project project = openedProject(options.project, context);
    Report report;
    std::optional<SurfaceFinish> finish;
    std::vector<std::string> warnings;
    if (options.layer) {
        TextureLayer& layer = layerNamed(project, *options.layer, LayersMeant::All);
        finishLayer(options, layer);
        if (layer.finish) finish = layer.finish->surface;
        warnings = finishWarnings(layer);
    } else {
        finishOrgan(options, project);
        finish = project.texture.finish;
    }
    output.save(project);
    if (project.texture.occlusionReach > 0) {
        report.json["occlusion_reach"] = project.texture.occlusionReach;
        report.text.push_back("organ: occlusion by what stands within " +
                              inText(project.texture.occlusionReach * millimetres) + " mm");
    }
    if (finish) report.json.update({{"roughness", finish->roughness}, {"wetness", finish->wetness}});
    report.text.push_back((options.layer ? "layer " + *options.layer : "organ") + ": " + finishText(finish));
    addWarnings(report, warnings);
    addWritten(report, options.output);
    return report;
}

} // namespace

void addFinishCommand(CLI::App& texture, Context& context) {
    addCommand(texture, context,
               Command<FinishOptions>{"finish", "Say how the organ or a layer shines: its finish",
                                      declareFinish, runFinish});
}

} // namespace esm
