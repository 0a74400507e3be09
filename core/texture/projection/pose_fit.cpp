#include "core/texture/projection/pose_fit.h"

#include "core/support/angles.h"
#include "core/support/errors.h"
#include "core/texture/projection/camera_search.h"
#include "core/texture/projection/camera_sources.h"
#include "core/texture/projection/pose_certainty.h"
#include "core/texture/projection/usable_pairs.h"
#include "core/texture/texture_limits.h"

#include <cmath>

namespace esm {

namespace {

constexpr int noiseRounds = 6;

/// Of the photo's diagonal: how far all may be off before one asks whether they are mirrored, and how far a
/// pair counts for that.
constexpr double doubtfulShare = 0.001, mirrorShare = 0.01;

struct Solution {
    CameraCandidate candidate;
    CameraSources sources;
};

CameraProblem problemOf(const std::vector<LandmarkPair>& pairs, const CameraCandidate& candidate,
                        const UsualCamera& usual, PhotoSize photo) {
    return {pairs, candidate.counts, usual, usualClickNoise(photo)};
}

/// A field of view that the program can hold.
bool isPossible(const PinholeCamera& camera, PhotoSize photo) {
    const double degrees = toDegrees(2 * std::atan(photo.height / (2 * camera.intrinsics.fy)));
    return degrees >= texture_limits::narrowestView && degrees <= texture_limits::widestView;
}

/// A part of the camera counts as found where the pairs say more of it than what is usual does. Principal
/// point and pixel aspect stay usual where they are not found, and where they are found to be usual, so that
/// a camera is no odder than the pairs ask for. The focal length is always sought: one that pairs do not tell
/// (few of them, or all in one depth) stays near a usual one, the pose is then off along the line of sight,
/// and the photo still lies where it should.
std::optional<Solution> withUnknownCamera(const std::vector<LandmarkPair>& pairs, PhotoSize photo) {
    const UsualCamera usual = usualCamera(photo);
    CameraCandidate found = foundCamera(pairs, photo);
    if (!isConvincing(found)) return std::nullopt;
    const CameraProblem problem = problemOf(pairs, found, usual, photo);
    const CameraFit whole = fitCamera(found.camera, problem, wholeCamera, noiseRounds);
    const CameraSources sources = sourcesOf(whole, usual);
    if (!isPossible(whole.camera, photo)) return std::nullopt;
    const CameraFreedom odd = oddParts(whole, usual, sources);
    found.camera = fitCamera(withUsualParts(whole.camera, usual, odd), problem, odd, noiseRounds).camera;
    return Solution{found, sources};
}

std::optional<Solution> solved(const std::vector<LandmarkPair>& pairs, const PhotoCamera& camera) {
    if (!camera.intrinsics)
        if (auto solution = withUnknownCamera(pairs, camera.size)) return solution;
    const CameraCandidate found = foundPose(
        pairs, camera.intrinsics ? *camera.intrinsics : usualCamera(camera.size).camera, camera.size);
    if (!isConvincing(found)) return std::nullopt;
    return Solution{found, CameraSources(camera.intrinsics ? PartSource::Given : PartSource::Assumed)};
}

/// What a solution is worth, with none that nothing agrees with.
double worth(const std::optional<Solution>& solution, const std::vector<LandmarkPair>& pairs,
             double tolerance) {
    if (!solution) return tolerance * tolerance * static_cast<double>(pairs.size());
    return cappedSquares(pairErrors(solution->candidate.camera, pairs), tolerance);
}

/// From far away a mirrored organ looks much like the organ from behind: some of the pairs may fit. So a fit
/// that is not good is compared with that of the pairs mirrored in the photo, and refused only where these
/// leave less than a quarter of the squares.
void requireUnmirrored(const std::optional<Solution>& found, std::vector<LandmarkPair> pairs,
                       const PhotoCamera& camera) {
    const double diagonal = std::hypot(camera.size.width, camera.size.height);
    const double tolerance = mirrorShare * diagonal, squares = worth(found, pairs, tolerance);
    if (squares <= std::pow(doubtfulShare * diagonal, 2) * static_cast<double>(pairs.size())) return;
    PhotoCamera mirrored = camera;
    for (LandmarkPair& pair : pairs)
        pair.photo.x() = camera.size.width - pair.photo.x();
    if (camera.intrinsics) mirrored.intrinsics->cx = camera.size.width - camera.intrinsics->cx;
    if (worth(solved(pairs, mirrored), pairs, tolerance) < squares / 4)
        throw InvalidModel(
            "the pairs are mirrored: they fit a photo with left and right exchanged; choose the "
            "points on the side of the organ that the photo shows, or mirror the photo");
}

/// OpenCV's camera looks along +z with y down, a projector along −z with y up: half a turn around x. The size
/// taken out by ScaledPairs is given back to the translation. A camera with usual parts is said by its field
/// of view.
Projector projectorOf(const PinholeCamera& camera, const ScaledPairs& scaled, const PhotoCamera& photo) {
    Projector projector;
    projector.kind = ProjectorKind::Perspective;
    projector.pose.linear() =
        camera.rotation.transpose() * Eigen::Vector3d(1, -1, -1).asDiagonal().toDenseMatrix();
    projector.pose.translation() = scaled.middle + scaled.size * camera.eye();
    projector.fieldOfView = toDegrees(2 * std::atan(photo.size.height / (2 * camera.intrinsics.fy)));
    const Intrinsics usual = usualCamera(photo.size).camera;
    const Intrinsics& found = camera.intrinsics;
    const bool isUsual =
        found.cx == usual.cx && found.cy == usual.cy && std::abs(found.fx / found.fy - 1) < 1e-12;
    projector.areIntrinsicsFound = !photo.intrinsics && !isUsual;
    if (photo.intrinsics)
        projector.intrinsics = photo.intrinsics;
    else if (!isUsual)
        projector.intrinsics = found;
    return projector;
}

void judge(PoseFit& fit, const Solution& solution, const ScaledPairs& scaled, const PhotoCamera& camera) {
    const auto& [candidate, sources] = solution;
    const UsualCamera usual = usualCamera(camera.size);
    const CameraProblem problem = problemOf(scaled.pairs, candidate, usual, camera.size);
    const CameraFreedom unknown = camera.intrinsics ? poseOnly : wholeCamera;
    const CameraFit likeliest = fitCamera(candidate.camera, problem, unknown, noiseRounds);
    const PoseCertainty certainty = poseCertainty(likeliest, problem, unknown, candidate.camera);
    fit.clickNoise = likeliest.clickNoise;
    fit.eyeWithin = scaled.size * certainty.eye;
    fit.turnWithin = certainty.turn;
    fit.focalLength = sources.focalLength;
    fit.principalPoint = sources.principalPoint;
    fit.pixelAspect = sources.pixelAspect;
    fit.dominating = dominatingAssumption(likeliest, sources);
    fit.weaknesses =
        weaknessesOf(scaled.pairs, candidate.counts, std::hypot(camera.size.width, camera.size.height));
}

} // namespace

PoseFit fitPose(const std::vector<LandmarkPair>& pairs, const PhotoCamera& camera) {
    requireUsable(pairs, camera.size);
    const ScaledPairs scaled(pairs);
    const auto found = solved(scaled.pairs, camera);
    requireUnmirrored(found, scaled.pairs, camera);
    if (!found)
        throw InvalidModel("no camera sees these pairs together: some are mixed up, or the focal length is "
                           "another");
    const CameraCandidate& best = found->candidate;
    PoseFit fit{};
    fit.projector = projectorOf(best.camera, scaled, camera);
    fit.errors = pairErrors(best.camera, scaled.pairs);
    double squares = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        fit.outliers.push_back(!best.counts[i]);
        squares += best.counts[i] ? fit.errors[i] * fit.errors[i] : 0;
    }
    fit.error = std::sqrt(squares / static_cast<double>(countOf(best.counts)));
    judge(fit, *found, scaled, camera);
    return fit;
}

} // namespace esm
