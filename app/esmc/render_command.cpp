#include "app/esmc/arguments.h"
#include "app/esmc/camera_file.h"
#include "app/esmc/commands.h"
#include "app/esmc/model_report.h"
#include "app/esmc/motion_frame.h"
#include "app/esmc/opened_file.h"
#include "core/dynamics/measure/scene_stages.h"
#include "core/exchange/image_file.h"
#include "core/offscreen/offscreen.h"
#include "core/render/organ_scene.h"
#include "core/texture/layers/composite.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <variant>

namespace esm {

namespace {

struct RenderOptions {
    std::string project, output, size = "1024x768", view = "front", camera, show, motion;
    std::optional<double> time; // s
    bool unlit = false;
};

void declareRender(CLI::App& command, RenderOptions& options) {
    command.add_option("project", options.project, "Project or model package")->required();
    command.add_option("-o,--output", options.output, "Picture to write (.png)")
        ->required()
        ->check(writtenAs(".png"));
    command.add_option("--size", options.size, "WIDTHxHEIGHT in pixels (1024x768)");
    CLI::Option* view = command.add_option(
        "--view", options.view,
        "front, back, left, right, top, bottom, or \"ex ey ez tx ty tz\", eye and target, m");
    command.add_option("--camera", options.camera, "The camera as a perspective projector file (.json)")
        ->excludes(view);
    command.add_option("--show", options.show,
                       "Any of surface, springs, regions, projectors, separated by commas (surface)");
    CLI::Option* motion = command.add_option(
        "--motion", options.motion, "The organ as a trajectory of simulate has it (.csv), not at rest");
    command.add_option("--at", options.time, "Time in the trajectory, s (its end)")
        ->needs(motion)
        ->check(nonNegativeNumber());
    command.add_flag("--unlit", options.unlit, "Colours of the texture without light");
}

PictureSize parseSize(const std::string& text) {
    const std::size_t cross = std::min(text.find('x'), text.size());
    const auto width = parseWholeNumber(text.substr(0, cross), 1, largestPictureSize);
    const auto height =
        parseWholeNumber(text.substr(std::min(cross + 1, text.size())), 1, largestPictureSize);
    if (!width || !height)
        throw UsageError("--size: '" + text + "' is not WIDTHxHEIGHT with numbers from 1 to " +
                         std::to_string(largestPictureSize));
    return {*width, *height};
}

/// "ex ey ez tx ty tz"
Camera freeCamera(const std::string& view) {
    const bool isWord = !view.empty() && std::isalpha(static_cast<unsigned char>(view.front()));
    const std::vector<double> numbers = isWord ? std::vector<double>() : parseNumbers(view, "--view");
    const bool isPair = numbers.size() == 6;
    Camera camera;
    if (isPair) camera.eye = {numbers[0], numbers[1], numbers[2]};
    if (isPair) camera.target = {numbers[3], numbers[4], numbers[5]};
    const Eigen::Vector3d sight = camera.target - camera.eye;
    if (!isPair || sight.norm() == 0)
        throw UsageError(
            "--view: give front, back, left, right, top, bottom, or six numbers, eye and target apart");
    if (std::abs(sight.normalized().y()) > 0.999) camera.up = {0, 0, sight.y() > 0 ? 1.0 : -1.0};
    return camera;
}

using RequestedView = std::variant<StandardView, Camera>;

/// Reads everything the line says of the camera, before the organ is read.
RequestedView requestedView(const RenderOptions& options, const PictureSize& size) {
    if (!options.camera.empty()) return readCameraFile(options.camera, {size.width, size.height});
    if (const auto view = standardViewFromName(options.view)) return *view;
    return freeCamera(options.view);
}

Camera cameraFor(const RequestedView& view, const Eigen::AlignedBox3d& box, double aspect) {
    const auto* standard = std::get_if<StandardView>(&view);
    return standard ? framedCamera(box, *standard, aspect) : std::get<Camera>(view);
}

void addRegions(RenderScene& scene, const std::vector<Region>& regions) {
    for (const Region& region : regions)
        if (region.ellipsoid) scene.ellipsoids.push_back(drawnEllipsoid(region, false));
}

using Shown = std::vector<std::string>;

bool shows(const Shown& shown, const char* part) {
    return std::find(shown.begin(), shown.end(), part) != shown.end();
}

RenderScene projectScene(const Project& project, const Shown& shown, Context& context) {
    RenderScene scene = organScene(project.mesh, project.network, project.texture.baseColour);
    if (project.atlas && !project.layers.empty())
        layTexture(scene, project.atlas,
                   std::make_shared<const std::vector<Image>>(
                       composite(*project.mesh, *project.atlas, project.layers, project.texture.baseColour,
                                 progressOf(context, "baking"))));
    scene.showSprings = scene.showSprings || shows(shown, "springs");
    if (scene.showSprings) colourSprings(scene, springConstants(evaluateModel(project)));
    if (shows(shown, "regions")) addRegions(scene, project.regions);
    if (shows(shown, "projectors"))
        for (const TextureLayer& layer : project.layers)
            if (layer.visible && layer.photo) scene.projectors.push_back(drawnProjector(scene, layer, false));
    return scene;
}

RenderScene packageScene(ModelPackage package, const Shown& shown) {
    RenderScene scene = organScene(std::make_shared<const TriangleMesh>(std::move(package.mesh)),
                                   package.tissue.network, package.baseColour);
    scene.showSprings = scene.showSprings || shows(shown, "springs");
    if (scene.showSprings) colourSprings(scene, springConstants(package.tissue));
    if (shows(shown, "regions")) addRegions(scene, package.regions);
    if (package.atlas)
        layTexture(scene, package.atlas,
                   std::make_shared<const std::vector<Image>>(std::move(package.textures)));
    return scene;
}

/// The organ as a trajectory has it, after as many splits of the scene as made the frame's nodes.
void showMotion(RenderScene& scene, const std::optional<Project>& project, const RenderOptions& options) {
    std::vector<SceneStage> stages;
    if (project)
        stages = laterStages(authoredTopology(project->mesh, project->network), evaluateModel(*project),
                             project->scene);
    std::vector<std::size_t> nodeCounts{scene.network->restPositions.size()};
    for (const SceneStage& stage : stages)
        nodeCounts.push_back(stage.organ.tissue.mass.size());
    scene.nodePositions = readMotionFrame(options.motion, nodeCounts, options.time);
    const SceneStage* stage = stageOfNodes(stages, scene.nodePositions.size());
    if (!stage) return;
    scene.mesh = stage->organ.topology.surface;
    scene.network = stage->organ.topology.network;
    if (scene.showSprings) colourSprings(scene, springConstants(stage->organ.tissue));
}

Report runRender(const RenderOptions& options, Context& context) {
    const PictureSize size = parseSize(options.size);
    const Shown named = parseWords(options.show, {"surface", "springs", "regions", "projectors"}, "--show");
    const Shown shown = named.empty() ? Shown{"surface"} : named;
    const RequestedView view = requestedView(options, size);
    context.subject = options.project;
    const bool isPackage = isModelPackage(options.project);
    std::optional<Project> project;
    if (!isPackage) project = openedProject(options.project, context);
    RenderScene scene = isPackage ? packageScene(openedPackage(options.project, context), shown)
                                  : projectScene(*project, shown, context);
    scene.showSurface = shows(shown, "surface");
    scene.unlit = options.unlit;
    if (!options.motion.empty()) showMotion(scene, project, options);
    const Camera camera =
        cameraFor(view, organBox(*scene.mesh, *scene.network), static_cast<double>(size.width) / size.height);
    writePng(renderOffscreen(scene, camera, size.width, size.height), options.output);
    Report report;
    report.json["size"] = {size.width, size.height};
    std::vector<std::string> warnings;
    if (isPackage && shows(shown, "projectors"))
        warnings.emplace_back("a package holds no projectors; draw the project to see them");
    addWarnings(report, warnings);
    addWritten(report, options.output);
    return report;
}

} // namespace

void addRenderCommand(CLI::App& app, Context& context) {
    addCommand(app, context,
               Command<RenderOptions>{"render", "Draw a picture of a project or a model package",
                                      declareRender, runRender});
}

} // namespace esm
