#include "core/texture/projection/camera_search.h"

#include "core/texture/projection/likely_cameras.h"
#include "core/texture/projection/usable_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

namespace {

/// Of the photo's diagonal: how far a pair may be off and still count, at first and at least.
constexpr double looseShare = 0.01, strictShare = 0.002;

/// Of the same: how far all may be off, root of the mean square, before one asks for an odd camera.
constexpr double goodShare = 0.003;

/// One camera is sought among all triples of up to 19 pairs; each of many with less effort.
constexpr SearchEffort forOneCamera{1000, 8}, forEachOfMany{200, 2};

std::vector<bool> within(const std::vector<double>& errors, double tolerance) {
    std::vector<bool> counts(errors.size());
    std::transform(errors.begin(), errors.end(), counts.begin(),
                   [=](double error) { return error <= tolerance; });
    return counts;
}

/// A search among pairs of a photo.
class CameraSearch {
public:
    CameraSearch(const std::vector<LandmarkPair>& pairs, PhotoSize photo)
        : m_pairs(pairs), m_usual(usualCamera(photo)), m_noise(usualClickNoise(photo)),
          m_diagonal(std::hypot(photo.width, photo.height)) {}

    /// With a wide tolerance, in which even a camera from three coarse clicks finds those that agree with it.
    CameraCandidate searched(const std::vector<Intrinsics>& cameras, const CameraFreedom& freedom,
                             double tolerance) const {
        CameraCandidate best = none();
        for (const Intrinsics& intrinsics : cameras)
            for (const PinholeCamera& likely : likelyCameras(
                     m_pairs, intrinsics, tolerance, cameras.size() == 1 ? forOneCamera : forEachOfMany)) {
                CameraCandidate candidate = settled(likely, freedom, tolerance);
                if (candidate.squares < best.squares) best = std::move(candidate);
            }
        return best;
    }

    /// With a tolerance that goes by the errors that are left: a pair that is off by ten pixels among others
    /// off by one is an outlier, though 1 % of the diagonal would let it pass.
    CameraCandidate refined(const CameraCandidate& loose, const CameraFreedom& freedom) const {
        if (loose.counts.empty()) return loose;
        CameraCandidate strict = settled(loose.camera, freedom, strictTolerance(loose, freedom));
        return strict.counts.empty() ? loose : strict;
    }

    double looseTolerance() const { return looseShare * m_diagonal; }
    const UsualCamera& usual() const { return m_usual; }

    double goodSquare() const { return std::pow(goodShare * m_diagonal, 2); }

    double meanSquare(const CameraCandidate& candidate) const {
        return cappedSquares(pairErrors(candidate.camera, m_pairs), looseTolerance()) /
               static_cast<double>(m_pairs.size());
    }

private:
    static CameraCandidate none() { return {{}, {}, std::numeric_limits<double>::infinity()}; }

    CameraFit fitted(const PinholeCamera& start, const std::vector<bool>& counts,
                     const CameraFreedom& freedom) const {
        return fitCamera(start, {m_pairs, counts, m_usual, m_noise}, freedom);
    }

    /// Fits to those that agree, asks again who agrees, until nothing changes.
    CameraCandidate settled(const PinholeCamera& start, const CameraFreedom& freedom,
                            double tolerance) const {
        CameraCandidate candidate{start, {}, 0};
        for (int round = 0; round < 10; ++round) {
            std::vector<bool> counts = within(pairErrors(candidate.camera, m_pairs), tolerance);
            if (countOf(counts) < leastPairs || counts == candidate.counts) break;
            candidate.counts = std::move(counts);
            candidate.camera = fitted(candidate.camera, candidate.counts, freedom).camera;
        }
        if (candidate.counts.empty()) return none();
        const std::vector<double> errors = pairErrors(candidate.camera, m_pairs);
        candidate.counts = within(errors, tolerance); // of this camera, where the rounds ended unsettled
        candidate.squares = cappedSquares(errors, tolerance);
        return candidate;
    }

    /// How far pairs that count may be off, by how far the middle one is. The errors of clicks are normal in
    /// both directions, so their length follows Rayleigh's distribution, whose median is √(2 ln 2) = 1.18
    /// standard deviations. A fit of k unknowns to n equations leaves errors smaller by √((n − k)/n) than the
    /// clicks' own. Beyond four standard deviations hardly any right pair lies (3 in 10 000); what does is
    /// taken for mixed up. The median, as half of the errors may be wrong without moving it far.
    double strictTolerance(const CameraCandidate& candidate, const CameraFreedom& freedom) const {
        std::vector<double> errors;
        const std::vector<double> all = pairErrors(candidate.camera, m_pairs);
        for (std::size_t i = 0; i < all.size(); ++i)
            if (candidate.counts[i]) errors.push_back(all[i]);
        const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
        std::nth_element(errors.begin(), middle, errors.end());
        const double equations = 2 * static_cast<double>(errors.size());
        const double told = fitted(candidate.camera, candidate.counts, freedom).told;
        const double deviation = *middle / 1.18 * std::sqrt(equations / std::max(1.0, equations - told));
        return std::clamp(4 * deviation, strictShare * m_diagonal, looseTolerance());
    }

    const std::vector<LandmarkPair>& m_pairs;
    UsualCamera m_usual;
    double m_noise, m_diagonal; ///< pixels
};

/// P3P needs a focal length, so without one a row of fields of view is tried, each some 1.2 to 1.5 times the
/// one before: near enough for least squares to find the true one from.
std::vector<Intrinsics> fieldsOfView(const Intrinsics& usual) {
    std::vector<Intrinsics> cameras;
    for (const double share : {8.26, 5.49, 3.64, 2.6, 1.95, 1.5, 1.18, 0.94, 0.75, 0.577, 0.443, 0.333, 0.21})
        cameras.push_back({share * usual.fx, share * usual.fy, usual.cx, usual.cy});
    return cameras;
}

/// The same for photos that were cropped or stretched, coarsely.
std::vector<Intrinsics> oddCameras(const UsualCamera& usual) {
    std::vector<Intrinsics> cameras;
    for (const double share : {3.64, 1.95, 1.18, 0.75, 0.443}) {
        for (const double aspect : {0.75, 0.87, 1.15, 1.33, 1.5})
            cameras.push_back({aspect * share * usual.camera.fx, share * usual.camera.fy, usual.camera.cx,
                               usual.camera.cy});
        for (const double x : {-5.0, 0.0, 5.0})
            for (const double y : {-3.0, 0.0, 3.0})
                if (x != 0 || y != 0)
                    cameras.push_back({share * usual.camera.fx, share * usual.camera.fy,
                                       usual.camera.cx + x * usual.principalScale,
                                       usual.camera.cy + y * usual.principalScale});
    }
    return cameras;
}

} // namespace

std::size_t countOf(const std::vector<bool>& counts) {
    return static_cast<std::size_t>(std::count(counts.begin(), counts.end(), true));
}

bool isConvincing(const CameraCandidate& candidate) {
    const std::size_t counting = countOf(candidate.counts);
    return counting >= leastPairs && 3 * counting >= 2 * candidate.counts.size();
}

CameraCandidate foundPose(const std::vector<LandmarkPair>& pairs, const Intrinsics& camera, PhotoSize photo) {
    const CameraSearch search(pairs, photo);
    return search.refined(search.searched({camera}, poseOnly, search.looseTolerance()), poseOnly);
}

/// First as usual cameras see, which most do; an odd one is sought only where none of them fits well. Pairs
/// that do not belong are sorted out before the whole camera is free, which would bend to meet them.
CameraCandidate foundCamera(const std::vector<LandmarkPair>& pairs, PhotoSize photo) {
    const CameraSearch search(pairs, photo);
    const auto found = [&](const std::vector<Intrinsics>& cameras, const CameraFreedom& freedom,
                           double tolerance) {
        const CameraCandidate loose = search.searched(cameras, freedom, tolerance);
        return search.refined(search.refined(loose, freedom), wholeCamera);
    };
    CameraCandidate usual =
        found(fieldsOfView(search.usual().camera), poseAndFocalLength, search.looseTolerance());
    if (isConvincing(usual) && search.meanSquare(usual) < search.goodSquare()) return usual;
    CameraCandidate odd = found(oddCameras(search.usual()), wholeCamera, 3 * search.looseTolerance());
    return search.meanSquare(odd) < search.meanSquare(usual) / 4 ? odd : usual;
}

} // namespace esm
