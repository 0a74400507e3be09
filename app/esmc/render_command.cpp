#include "app/esmc/arguments.h"
#include "app/esmc/camera_file.h"
#include "app/esmc/commands.h"
#include "app/esmc/model_report.h"
#include "app/esmc/motion_frame.h"
#include "app/esmc/opened_file.h"
#include "core/authoring/baked_pages.h"
#include "core/dynamics/measure/scene_stages.h"
#include "core/exchange/image_file.h"
#include "core/offscreen/offscreen.h"
#include "core/render/organ_scene.h"
#include "core/render/view_state.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <variant>

namespace esm {

namespace {

struct RenderOptions {
    std::string project, output, size = "1024x768", view = "front", camera, show, motion,
                                 colourBy = "texture";
    std::optional<std::string> cut;
    std::optional<double> time; // s
    bool unlit = false, orthographic = false;
    SceneLight light = SceneLight::Room;
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
    CLI::Option* camera =
        command.add_option("--camera", options.camera, "The camera as a perspective projector file (.json)")
            ->excludes(view);
    command
        .add_flag("--orthographic", options.orthographic, "Without perspective: sizes alike at all depths")
        ->excludes(camera);
    command.add_option(
        "--show", options.show,
        "Any of surface, wireframe, springs, nodes, regions, projectors, separated by commas (surface)");
    command.add_option("--colour-by", options.colourBy,
                       "texture, spring-constant, viscosity, mass, strain, speed or region (texture)");
    command.add_option("--cut", options.cut,
                       "SIDE:SHARE, that share of the organ hidden from viewer, +x, -x, +y, -y, +z or -z on");
    CLI::Option* motion = command.add_option(
        "--motion", options.motion, "The organ as a trajectory of simulate has it (.csv), not at rest");
    command.add_option("--at", options.time, "Time in the trajectory, s (its end)")
        ->needs(motion)
        ->check(nonNegativeNumber());
    CLI::Option* unlit = command.add_flag("--unlit", options.unlit, "Colours of the texture without light");
    addChoice(command, "--light", options.light,
              {{"room", SceneLight::Room}, {"endoscope", SceneLight::Endoscope}},
              "Lamps of a room, or the endoscope's own at the camera (room)")
        ->excludes(unlit);
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

Camera cameraFor(const RequestedView& view, bool isOrthographic, const Eigen::AlignedBox3d& box,
                 double aspect) {
    const auto* standard = std::get_if<StandardView>(&view);
    Camera camera = standard ? framedCamera(box, *standard, aspect) : std::get<Camera>(view);
    if (!isOrthographic) return camera;
    return standard ? reframed(orthographic(camera), box, aspect) : orthographic(camera);
}

/// "SIDE:SHARE"
Cut requestedCut(const std::string& text) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const auto side = cutSideFromName(text.substr(0, colon));
    const std::vector<double> shares = parseNumbers(text.substr(std::min(colon + 1, text.size())), "--cut");
    if (!side || shares.size() != 1 || shares[0] < 0 || shares[0] > 1)
        throw UsageError(
            "--cut: '" + text +
            "' is not SIDE:SHARE, one of viewer, +x, -x, +y, -y, +z, -z and a number from 0 to 1");
    return Cut{*side, shares[0]};
}

ColourBy requestedColouring(const RenderOptions& options) {
    const auto by = colourByFromName(options.colourBy);
    if (!by)
        throw UsageError("--colour-by: '" + options.colourBy +
                         "' is none of texture, spring-constant, viscosity, mass, strain, speed, region");
    if (followsMotion(*by) && options.motion.empty())
        throw UsageError("--colour-by " + options.colourBy +
                         ": an organ at rest has none; give a trajectory with --motion");
    return *by;
}

void addRegions(RenderScene& scene, const std::vector<Region>& regions) {
    for (const Region& region : regions)
        if (region.ellipsoid) scene.ellipsoids.push_back(drawnEllipsoid(region, false));
}

using Shown = std::vector<std::string>;

bool shows(const Shown& shown, const char* part) {
    return std::find(shown.begin(), shown.end(), part) != shown.end();
}

/// What is drawn, and what it is coloured by.
struct Subject {
    RenderScene scene;
    TissueModel tissue;
    std::vector<Region> regions;
    std::vector<double> speeds; ///< m/s, of moving tissue
};

Subject projectSubject(const Project& project, bool showsProjectors, Context& context) {
    Subject subject{organScene(project.mesh, project.network, project.texture.baseColour),
                    evaluateModel(project),
                    project.regions,
                    {}};
    RenderScene& scene = subject.scene;
    BakedPages pages;
    if (!project.layers.empty()) pages = bakedPages(project, progressOf(context, "baking"));
    if (pages.colours) layTexture(scene, project.atlas, *pages.colours);
    layFinish(scene, project.layers, project.texture.finish, pages.finish);
    if (showsProjectors)
        for (const TextureLayer& layer : project.layers)
            if (layer.visible && layer.photo) scene.projectors.push_back(drawnProjector(scene, layer, false));
    return subject;
}

Subject packageSubject(ModelPackage package) {
    RenderScene scene = organScene(std::make_shared<const TriangleMesh>(std::move(package.mesh)),
                                   package.tissue.network, package.baseColour);
    if (package.atlas) layTexture(scene, package.atlas, package.textures);
    if (package.finish || package.finishPages) scene.finish = package.finish.value_or(SurfaceFinish{});
    scene.finishPages = package.finishPages;
    return {std::move(scene), std::move(package.tissue), std::move(package.regions), {}};
}

/// The organ as a trajectory has it, after as many splits of the scene as made the frame's nodes.
void showMotion(Subject& subject, const std::optional<Project>& project, const RenderOptions& options) {
    RenderScene& scene = subject.scene;
    std::vector<SceneStage> stages;
    if (project)
        stages =
            laterStages(authoredTopology(project->mesh, project->network), subject.tissue, project->scene);
    std::vector<std::size_t> nodeCounts{scene.network->restPositions.size()};
    for (const SceneStage& stage : stages)
        nodeCounts.push_back(stage.organ.tissue.mass.size());
    const MotionFrame frame = readMotionFrame(options.motion, nodeCounts, options.time);
    if (options.colourBy == nameOf(ColourBy::Speed))
        subject.speeds = readSpeeds(options.motion, nodeCounts, frame);
    scene.nodePositions = frame.positions;
    const SceneStage* stage = stageOfNodes(stages, scene.nodePositions.size());
    if (!stage) return;
    scene.mesh = stage->organ.topology.surface;
    scene.network = stage->organ.topology.network;
    subject.tissue = stage->organ.tissue;
}

ViewState requestedState(const RenderOptions& options) {
    const Shown named = parseWords(
        options.show, {"surface", "wireframe", "springs", "nodes", "regions", "projectors"}, "--show");
    ViewState state;
    state.surface = named.empty() || shows(named, "surface");
    state.wireframe = shows(named, "wireframe");
    state.springs = shows(named, "springs");
    state.nodes = shows(named, "nodes");
    state.regions = shows(named, "regions");
    state.colourBy = requestedColouring(options);
    state.light = options.light;
    if (options.cut) state.cut = requestedCut(*options.cut);
    return state;
}

/// What the colours of the picture mean.
Json legendJson(const ColourLegend& legend) {
    Json json{{"title", legend.title}};
    if (legend.unit.empty()) {
        json["regions"] = Json::array();
        for (const auto& [name, colour] : legend.entries)
            json["regions"].push_back({{"name", name}, {"colour", colour}});
        return json;
    }
    json["unit"] = legend.unit;
    json["minimum"] = legend.range.minimum;
    json["maximum"] = legend.range.maximum;
    return json;
}

/// Colours what asks for it: springs always do.
std::optional<ColourLegend> colour(Subject& subject, const ViewState& state) {
    if (state.colourBy == ColourBy::Texture && !subject.scene.showSprings) return std::nullopt;
    std::optional<ValueRange> range;
    return colourScene(subject.scene, state.colourBy, {subject.tissue, subject.regions, subject.speeds},
                       range);
}

Report runRender(const RenderOptions& options, Context& context) {
    const PictureSize size = parseSize(options.size);
    const ViewState state = requestedState(options);
    const bool showsProjectors = options.show.find("projectors") != std::string::npos;
    const RequestedView view = requestedView(options, size);
    context.subject = options.project;
    const bool isPackage = isModelPackage(options.project);
    std::optional<Project> project;
    if (!isPackage) project = openedProject(options.project, context);
    Subject subject = isPackage ? packageSubject(openedPackage(options.project, context))
                                : projectSubject(*project, showsProjectors, context);
    RenderScene& scene = subject.scene;
    scene.unlit = options.unlit;
    if (!options.motion.empty()) showMotion(subject, project, options);
    if (state.regions) addRegions(scene, subject.regions);
    const Camera camera = cameraFor(view, options.orthographic, organBox(*scene.mesh, *scene.network),
                                    static_cast<double>(size.width) / size.height);
    showParts(scene, state, camera);
    const std::optional<ColourLegend> legend = colour(subject, state);
    writePng(renderOffscreen(scene, camera, size.width, size.height), options.output);
    Report report;
    report.json["size"] = {size.width, size.height};
    if (legend) report.json["legend"] = legendJson(*legend);
    std::vector<std::string> warnings;
    if (isPackage && showsProjectors)
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
