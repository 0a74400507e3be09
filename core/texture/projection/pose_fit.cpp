#include "core/texture/projection/pose_fit.h"

#include "core/support/angles.h"
#include "core/support/errors.h"
#include "core/texture/projection/pose_search.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <cmath>
#include <Eigen/SVD>

namespace esm {

namespace {

constexpr std::size_t leastPairs = 4, leastPairsForFocalLength = 6;

/// Of the photo's diagonal: how far a pair may be off and still count, at first and at least.
constexpr double looseShare = 0.01, strictShare = 0.002;

/// Of the same: how far all may be off before one asks whether they are mirrored.
constexpr double doubtfulShare = 0.001;

/// Of the extent of points: narrower across, they are a line.
constexpr double lineShare = 1e-3;

/// The most uncertain that a focal length may be to count as measured: the standard deviation of its
/// logarithm, for clicks as exact as these were. 0.3 is a third more or a quarter less.
constexpr double mostSlack = 0.3;

/// Candidates that are worth a least-squares fit each.
constexpr std::size_t candidates = 8;

template<typename Points> bool isOnALine(const Points& points) {
    const auto centred = (points.colwise() - points.rowwise().mean()).eval();
    const auto sizes = Eigen::JacobiSVD<Eigen::MatrixXd>(centred).singularValues().eval();
    return sizes[1] <= lineShare * sizes[0];
}

std::string numbersOf(std::size_t first, std::size_t second) {
    return std::to_string(first + 1) + " and " + std::to_string(second + 1);
}

void requireDistinct(const std::vector<LandmarkPair>& pairs) {
    for (std::size_t i = 0; i < pairs.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (pairs[i].photo == pairs[j].photo || pairs[i].organ == pairs[j].organ)
                throw InvalidModel("the pairs " + numbersOf(j, i) +
                                   " share a point; each landmark needs its own");
}

/// A click may miss the border by a little; more, and it is another photo's.
void requireInside(const Eigen::Vector2d& place, std::size_t pair, const PhotoSize& size) {
    const double margin = looseShare * std::hypot(size.width, size.height);
    if (place.minCoeff() >= -margin && place.x() <= size.width + margin && place.y() <= size.height + margin)
        return;
    throw InvalidModel("pair " + std::to_string(pair + 1) + " lies outside the photo of " +
                       std::to_string(size.width) + " × " + std::to_string(size.height) +
                       " pixels: it is another photo's, or the photo was scaled");
}

void requireUsable(const std::vector<LandmarkPair>& pairs, const PhotoSize& size) {
    if (pairs.size() < leastPairs)
        throw InvalidModel("there are " + std::to_string(pairs.size()) + " pairs; a pose takes 4 or more");
    Eigen::Matrix2Xd photo(2, pairs.size());
    Eigen::Matrix3Xd organ(3, pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (!pairs[i].photo.allFinite() || !pairs[i].organ.allFinite())
            throw InvalidModel("pair " + std::to_string(i + 1) + " is not finite");
        requireInside(pairs[i].photo, i, size);
        photo.col(static_cast<Eigen::Index>(i)) = pairs[i].photo;
        organ.col(static_cast<Eigen::Index>(i)) = pairs[i].organ;
    }
    requireDistinct(pairs);
    for (const bool isInPhoto : {true, false})
        if (isInPhoto ? isOnALine(photo) : isOnALine(organ))
            throw InvalidModel(std::string("the points ") + (isInPhoto ? "in the photo" : "on the organ") +
                               " lie on a line; add pairs beside it");
}

/// The pairs with the organ's points around the origin and of size 1, as solvers like them.
struct ScaledPairs {
    explicit ScaledPairs(const std::vector<LandmarkPair>& given) : pairs(given) {
        for (const LandmarkPair& pair : pairs)
            middle += pair.organ / static_cast<double>(pairs.size());
        for (const LandmarkPair& pair : pairs)
            size = std::max(size, (pair.organ - middle).norm());
        for (LandmarkPair& pair : pairs)
            pair.organ = (pair.organ - middle) / size;
    }

    std::vector<LandmarkPair> pairs;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(); ///< m
    double size = 0;                                  ///< m
};

struct Candidate {
    PinholeCamera camera;
    std::vector<bool> counts;
    double squares = std::numeric_limits<double>::infinity();
    double slack = 0;
};

std::vector<bool> within(const std::vector<double>& errors, double tolerance) {
    std::vector<bool> counts(errors.size());
    std::transform(errors.begin(), errors.end(), counts.begin(),
                   [=](double error) { return error <= tolerance; });
    return counts;
}

std::size_t countOf(const std::vector<bool>& counts) {
    return static_cast<std::size_t>(std::count(counts.begin(), counts.end(), true));
}

/// Fits to those that agree, asks again who agrees, until nothing changes.
Candidate settled(PinholeCamera camera, const std::vector<LandmarkPair>& pairs, Freedom freedom,
                  double tolerance) {
    Candidate candidate;
    candidate.camera = camera;
    for (int round = 0; round < 10; ++round) {
        std::vector<bool> counts = within(pairErrors(candidate.camera, pairs), tolerance);
        const std::size_t least = freedom == Freedom::Pose ? leastPairs : leastPairsForFocalLength;
        if (countOf(counts) < least || counts == candidate.counts) break;
        candidate.counts = std::move(counts);
        candidate.camera = leastSquares(candidate.camera, pairs, candidate.counts, freedom, &candidate.slack);
    }
    if (candidate.counts.empty()) return candidate;
    const std::vector<double> errors = pairErrors(candidate.camera, pairs);
    candidate.counts =
        within(errors, tolerance); // of this camera, where the rounds ended before they settled
    candidate.squares = cappedSquares(errors, tolerance);
    return candidate;
}

/// How far pairs that count may be off, by how far the middle one is. The errors of clicks are normal in both
/// directions, so their length follows Rayleigh's distribution, whose median is √(2 ln 2) = 1.18 standard
/// deviations. A fit of k unknowns to n equations leaves errors smaller by √((n − k)/n) than the clicks' own.
/// Beyond four standard deviations hardly any right pair lies (3 in 10 000); what does is taken for mixed up.
/// The median, as half of the errors may be wrong without moving it far.
double strictTolerance(const Candidate& candidate, const std::vector<LandmarkPair>& pairs, Freedom freedom,
                       double diagonal) {
    std::vector<double> errors;
    const std::vector<double> all = pairErrors(candidate.camera, pairs);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (candidate.counts[i]) errors.push_back(all[i]);
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::nth_element(errors.begin(), middle, errors.end());
    const double equations = 2 * static_cast<double>(errors.size());
    const double free = equations - (freedom == Freedom::Pose ? 6 : 7);
    // In a plane half of the errors are below 1.18 standard deviations; fitting makes them smaller.
    const double deviation = *middle / 1.18 * std::sqrt(equations / free);
    return std::clamp(4 * deviation, strictShare * diagonal, looseShare * diagonal);
}

/// First with a wide tolerance, in which even a camera from three coarse clicks finds those that agree with
/// it, then with one that goes by the errors that are left: a pair that is off by ten pixels among others off
/// by one is an outlier, though 1 % of the diagonal would let it pass.
Candidate bestCandidate(const std::vector<LandmarkPair>& pairs, const std::vector<Intrinsics>& cameras,
                        Freedom freedom, double diagonal) {
    Candidate best;
    for (const Intrinsics& intrinsics : cameras)
        for (const PinholeCamera& likely :
             likelyCameras(pairs, intrinsics, looseShare * diagonal, candidates)) {
            Candidate candidate = settled(likely, pairs, freedom, looseShare * diagonal);
            if (candidate.squares < best.squares) best = std::move(candidate);
        }
    if (best.counts.empty()) return best;
    const double strict = strictTolerance(best, pairs, freedom, diagonal);
    Candidate stricter = settled(best.camera, pairs, freedom, strict);
    return stricter.counts.empty() ? best : stricter;
}

Intrinsics fromFieldOfView(double degrees, PhotoSize photo) {
    Projector projector;
    projector.fieldOfView = degrees;
    return intrinsicsOf(projector, photo);
}

/// Four pairs at least and two in three: any three pairs fit some camera exactly, so that a few that agree
/// prove nothing.
bool isConvincing(const Candidate& candidate) {
    const std::size_t counting = countOf(candidate.counts);
    return counting >= leastPairs && 3 * counting >= 2 * candidate.counts.size();
}

struct Solution {
    Candidate candidate;
    FocalLength focalLength;
};

/// P3P needs a focal length, so without one a row of fields of view is tried, each some 1.2 to 1.5 times the
/// one before: near enough for least squares to find the true one from. Where pairs do not tell it (few of
/// them, or all in one depth), a usual one is assumed: the pose is then off along the line of sight, and the
/// photo still lies where it should.
std::optional<Solution> solved(const std::vector<LandmarkPair>& pairs, const PhotoCamera& camera) {
    const double diagonal = std::hypot(camera.size.width, camera.size.height);
    if (!camera.intrinsics && pairs.size() >= leastPairsForFocalLength) {
        std::vector<Intrinsics> cameras;
        for (const double degrees : {8, 12, 18, 25, 33, 42, 52, 63, 75, 90, 105, 120, 140})
            cameras.push_back(fromFieldOfView(degrees, camera.size));
        const Candidate found = bestCandidate(pairs, cameras, Freedom::PoseAndFocalLength, diagonal);
        const double degrees =
            toDegrees(2 * std::atan(camera.size.height / (2 * found.camera.intrinsics.fy)));
        if (isConvincing(found) && found.slack <= mostSlack && degrees >= texture_limits::narrowestView &&
            degrees <= texture_limits::widestView)
            return Solution{found, FocalLength::Measured};
    }
    const Intrinsics known =
        camera.intrinsics ? *camera.intrinsics : fromFieldOfView(assumedFieldOfView, camera.size);
    const Candidate found = bestCandidate(pairs, {known}, Freedom::Pose, diagonal);
    if (!isConvincing(found)) return std::nullopt;
    return Solution{found, camera.intrinsics ? FocalLength::Given : FocalLength::Assumed};
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
    const double tolerance = looseShare * diagonal, squares = worth(found, pairs, tolerance);
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
/// taken out by ScaledPairs is given back to the translation.
Projector projectorOf(const PinholeCamera& camera, const ScaledPairs& scaled, const PhotoCamera& photo,
                      FocalLength focalLength) {
    Projector projector;
    projector.kind = ProjectorKind::Perspective;
    projector.pose.linear() =
        camera.rotation.transpose() * Eigen::Vector3d(1, -1, -1).asDiagonal().toDenseMatrix();
    projector.pose.translation() =
        scaled.middle - scaled.size * camera.rotation.transpose() * camera.translation;
    if (focalLength == FocalLength::Given)
        projector.intrinsics = photo.intrinsics;
    else if (focalLength == FocalLength::Measured)
        projector.fieldOfView = toDegrees(2 * std::atan(photo.size.height / (2 * camera.intrinsics.fy)));
    else
        projector.fieldOfView = assumedFieldOfView;
    return projector;
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
    const auto& [best, focalLength] = *found;
    PoseFit fit;
    fit.projector = projectorOf(best.camera, scaled, camera, focalLength);
    fit.focalLength = focalLength;
    fit.errors = pairErrors(best.camera, scaled.pairs);
    double squares = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        fit.outliers.push_back(!best.counts[i]);
        squares += best.counts[i] ? fit.errors[i] * fit.errors[i] : 0;
    }
    fit.error = std::sqrt(squares / static_cast<double>(countOf(best.counts)));
    return fit;
}

} // namespace esm
