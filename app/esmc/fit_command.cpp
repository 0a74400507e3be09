#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/opened_file.h"
#include "core/exchange/project/pairs_file.h"
#include "core/exchange/project/projector_file.h"
#include "core/support/atomic_file.h"
#include "core/support/numbers.h"
#include "core/texture/layers/pose_refinement.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Landmarks further from the organ's box than this share of its diagonal are hardly in metres.
constexpr double farShare = 0.5;

struct FitOptions {
    std::string project, photo, pairs, intrinsics, output;
    bool refine = false;
};

void declareFit(CLI::App& command, FitOptions& options) {
    command.add_option("project", options.project, "Project to read (.esm)")->required();
    command.add_option("--photo", options.photo, "Photograph (PNG or JPEG)")->required();
    command
        .add_option("--pairs", options.pairs, "Landmarks: photo_x,photo_y,x,y,z, pixels and metres (.csv)")
        ->required();
    command.add_option(
        "--intrinsics", options.intrinsics,
        "FX,FY,CX,CY of the photograph's camera, pixels; without, found as far as the pairs tell");
    command.add_flag("--refine", options.refine,
                     "Then move the photograph so that it agrees with those on the organ already");
    command.add_option("-o,--output", options.output, "Projector file to write (.json)")
        ->check(writtenAs(".json"));
}

std::optional<Intrinsics> parseIntrinsics(const std::string& text) {
    if (text.empty()) return std::nullopt;
    const std::vector<double> numbers = parseNumbers(text, "--intrinsics");
    if (numbers.size() != 4) throw UsageError("--intrinsics: give four numbers, FX,FY,CX,CY, in pixels");
    const Intrinsics camera{numbers[0], numbers[1], numbers[2], numbers[3]};
    constexpr double most = texture_limits::longestFocalLength;
    if (!(std::min(camera.fx, camera.fy) > 0 && std::max(camera.fx, camera.fy) <= most))
        throw UsageError("--intrinsics: the focal lengths FX and FY must be above 0 and at most 1e7 pixels");
    if (std::abs(camera.cx) > most || std::abs(camera.cy) > most)
        throw UsageError("--intrinsics: the principal point CX, CY must be within 1e7 pixels");
    return camera;
}

const char* inWords(CameraPart part) {
    switch (part) {
    case CameraPart::FocalLength:
        return "the focal length";
    case CameraPart::PrincipalPoint:
        return "where the line of sight meets the photograph";
    case CameraPart::PixelAspect:
        return "whether pixels are square";
    }
    return "";
}

const char* adviceOn(Weakness weakness) {
    switch (weakness) {
    case Weakness::NearlyOnALine:
        return "the pairs lie nearly on a line, which leaves the turn about it open: add pairs beside it";
    case Weakness::NearlyPlanar:
        return "the pairs lie nearly in a plane, which hardly tells near from zoomed: add pairs before or "
               "behind it";
    case Weakness::CloseTogether:
        return "the pairs lie close together in the photograph: add pairs further out";
    }
    return "";
}

/// How many times wider a photo is than square pixels would make it, where the pairs found that out.
double stretchOf(const PoseFit& fit) {
    const bool isFound = fit.pixelAspect == PartSource::Found && fit.projector.intrinsics;
    return isFound ? std::round(1e4 * fit.projector.intrinsics->fx / fit.projector.intrinsics->fy) / 1e4 : 1;
}

std::vector<std::string> fitWarnings(const PoseFit& fit, const std::vector<LandmarkPair>& pairs,
                                     const TriangleMesh& mesh) {
    std::vector<std::string> warnings;
    Eigen::AlignedBox3d near = boundingBox(mesh.vertices);
    const double reach = farShare * near.diagonal().norm();
    const auto isFar = [&](const LandmarkPair& pair) { return near.exteriorDistance(pair.organ) > reach; };
    if (std::any_of(pairs.begin(), pairs.end(), isFar))
        warnings.emplace_back(
            "some landmarks lie far from the organ: x, y and z are metres in its own space");
    if (fit.dominating)
        warnings.push_back(
            "how sure the pose is hangs on " + std::string(inWords(*fit.dominating)) +
            ", which the pairs hardly tell: it was taken as in usual cameras; give more pairs, "
            "well spread over the photograph and in depth, or --intrinsics");
    for (const Weakness weakness : fit.weaknesses)
        warnings.emplace_back(adviceOn(weakness));
    if (const double stretch = stretchOf(fit); stretch != 1)
        warnings.push_back("the photograph is stretched: it is " + inText(stretch) +
                           " times as wide as square pixels would make it");
    return warnings;
}

/// Without digits that nobody can see, and without a minus before zero.
std::string rounded(const Eigen::Vector3d& value, double unit) {
    const Eigen::Vector3d whole = (value / unit).array().round() + 0.0;
    return inText(Eigen::Vector3d(whole * unit));
}

void addPoseText(Report& report, const Projector& camera) {
    constexpr double micrometre = 1e-6, share = 1e-4;
    const Eigen::Matrix3d axes = camera.pose.linear();
    report.text.push_back("the eye is at " + rounded(camera.pose.translation(), micrometre) + " m");
    report.text.push_back("it looks along " + rounded(-axes.col(2), share) + "; up in the photograph is " +
                          rounded(axes.col(1), share));
}

/// The camera in words: where it stands, which way it looks and how wide.
void addCameraText(Report& report, const PoseFit& fit) {
    const Projector& camera = fit.projector;
    addPoseText(report, camera);
    report.text.push_back("with 95 % certainty the true eye is within " +
                          roundedText(1000 * fit.eyeWithin, 3) + " mm of it, and the true turn within " +
                          roundedText(fit.turnWithin, 3) + " degrees");
    const std::string how = std::string(" (") + wordOf(fit.focalLength) + ")";
    if (camera.intrinsics)
        report.text.push_back("focal lengths " + inText(camera.intrinsics->fx) + ", " +
                              inText(camera.intrinsics->fy) + " pixels" + how + ", line of sight through " +
                              inText(camera.intrinsics->cx) + ", " + inText(camera.intrinsics->cy) +
                              " pixels (" + wordOf(fit.principalPoint) + ")");
    else
        report.text.push_back("vertical field of view " + inText(std::round(100 * camera.fieldOfView) / 100) +
                              " degrees" + how + ", line of sight in the middle (" +
                              wordOf(fit.principalPoint) + "), square pixels (" + wordOf(fit.pixelAspect) +
                              ")");
}

Report describe(const PoseFit& fit) {
    Report report;
    Json errors = Json::array(), outliers = Json::array();
    std::string strangers;
    for (std::size_t i = 0; i < fit.errors.size(); ++i) {
        errors.push_back(std::isfinite(fit.errors[i]) ? Json(fit.errors[i]) : Json());
        if (!fit.outliers[i]) continue;
        outliers.push_back(i + 1);
        strangers += (strangers.empty() ? "" : ", ") + std::to_string(i + 1);
    }
    report.json = {{"projector", toJson(fit.projector)},
                   {"reprojection_error_px", fit.error},
                   {"errors_px", errors},
                   {"outliers", outliers},
                   {"focal_length", wordOf(fit.focalLength)},
                   {"principal_point", wordOf(fit.principalPoint)},
                   {"pixel_aspect", wordOf(fit.pixelAspect)},
                   {"click_noise_px", fit.clickNoise},
                   {"eye_within", fit.eyeWithin},
                   {"turn_within", fit.turnWithin},
                   {"hangs_on", fit.dominating ? Json(wordOf(*fit.dominating)) : Json()},
                   {"weak", Json::array()}};
    for (const Weakness weakness : fit.weaknesses)
        report.json["weak"].push_back(wordOf(weakness));
    addCameraText(report, fit);
    report.text.push_back("off by " + roundedText(fit.error, 3) + " pixels");
    if (!strangers.empty())
        report.text.push_back("pairs that do not fit the others, and do not count: " + strangers);
    return report;
}

void writeProjector(const Projector& projector, const std::filesystem::path& file,
                    Interruption& interruption) {
    AtomicFile output(file);
    output.write(toJson(projector).dump(2) + "\n");
    interruption.disarm();
    output.commit();
}

/// Moves the fit's projector where the photos on the organ tell more; warns where they do not.
void refine(Report& report, std::vector<std::string>& warnings, PoseFit& fit, const Project& project,
            const std::shared_ptr<const Photo>& photo, const Context& context) {
    TextureLayer layer;
    layer.photo = photo;
    layer.projector = fit.projector;
    const auto refined = refinedPose(*project.mesh, project.layers, layer, progressOf(context, "refining"));
    report.json["refined"] = Json();
    if (!refined) {
        warnings.emplace_back("the photograph was not refined: it meets too little of other photographs, or "
                              "agrees with them as well as it can");
        return;
    }
    fit.projector = refined->projector;
    report.json["projector"] = toJson(fit.projector);
    report.json["refined"] = {{"error_before", refined->errorBefore},
                              {"error_after", refined->errorAfter},
                              {"moved_px", refined->moved}};
    report.text.push_back("refined by the photographs on the organ: moved by " +
                          roundedText(refined->moved, 3) + " pixels; it differs from them by " +
                          roundedText(100 * refined->errorAfter, 3) + " % of the contrast, before by " +
                          roundedText(100 * refined->errorBefore, 3) + " %; now");
    addPoseText(report, fit.projector);
}

Report runFit(const FitOptions& options, Context& context) {
    const std::optional<Intrinsics> intrinsics = parseIntrinsics(options.intrinsics);
    context.subject = options.project;
    const Project project = openedProject(options.project, context);
    const std::shared_ptr<const Photo> photo = loadPhoto(options.photo);
    const std::vector<LandmarkPair> pairs = readPairsFile(options.pairs);
    context.subject = options.pairs;
    PoseFit fit = fitPose(pairs, {{photo->image.width, photo->image.height}, intrinsics});
    Report report = describe(fit);
    std::vector<std::string> warnings = fitWarnings(fit, pairs, *project.mesh);
    if (options.refine) refine(report, warnings, fit, project, photo, context);
    addWarnings(report, warnings);
    if (options.output.empty()) return report;
    writeProjector(fit.projector, options.output, context.interruption);
    addWritten(report, options.output);
    return report;
}

} // namespace

void addFitCommand(CLI::App& texture, Context& context) {
    addCommand(texture, context,
               Command<FitOptions>{"fit", "Find where a photograph was taken from, by landmarks", declareFit,
                                   runFit});
}

} // namespace esm
