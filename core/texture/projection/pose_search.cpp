#include "core/texture/projection/pose_search.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <limits>
#include <opencv2/calib3d.hpp>

namespace esm {

namespace {

/// All triples of up to 19 pairs (969); of more pairs as many in effect, spread evenly, which takes no random
/// numbers.
constexpr std::size_t mostTriples = 1000;

/// Levenberg-Marquardt's damping, relative to the diagonal.
constexpr double firstDamping = 1e-3, leastDamping = 1e-12, mostDamping = 1e12;
constexpr int mostSteps = 100;

using Triple3 = std::array<std::size_t, 3>;

/// The triple of that number among all of `count` in lexicographic order (the combinatorial number system):
/// any of them at once, without making those before it.
Triple3 tripleAt(std::size_t number, std::size_t count) {
    Triple3 triple{};
    for (;; ++triple[0]) {
        const std::size_t left = count - triple[0] - 1, pairs = left * (left - 1) / 2;
        if (number < pairs) break;
        number -= pairs;
    }
    for (triple[1] = triple[0] + 1; number >= count - triple[1] - 1; ++triple[1])
        number -= count - triple[1] - 1;
    triple[2] = triple[1] + 1 + number;
    return triple;
}

/// All of them, or so many evenly spread over them.
std::vector<Triple3> triplesOf(std::size_t count) {
    const std::size_t all = count * (count - 1) * (count - 2) / 6, chosen = std::min(all, mostTriples);
    std::vector<Triple3> triples(chosen);
    for (std::size_t i = 0; i < chosen; ++i)
        triples[i] = tripleAt(i * all / chosen, count);
    return triples;
}

cv::Matx33d matrixOf(const Intrinsics& camera) {
    return {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
}

/// Three points that are seen leave up to four poses (P3P, Grunert 1841); each of them is a candidate, and
/// the other pairs decide. Three and not four or more, as the fewer pairs a candidate takes, the more likely
/// all of them are right: RANSAC (Fischler and Bolles 1981), but with all triples in place of random ones.
void addCamerasOf(const Triple3& triple, const std::vector<LandmarkPair>& pairs, const Intrinsics& intrinsics,
                  std::vector<PinholeCamera>& cameras) {
    std::vector<cv::Point3d> organ;
    std::vector<cv::Point2d> photo;
    for (const std::size_t i : triple) {
        organ.emplace_back(pairs[i].organ.x(), pairs[i].organ.y(), pairs[i].organ.z());
        photo.emplace_back(pairs[i].photo.x(), pairs[i].photo.y());
    }
    std::vector<cv::Mat> turns, shifts;
    try {
        cv::solveP3P(organ, photo, matrixOf(intrinsics), cv::noArray(), turns, shifts, cv::SOLVEPNP_P3P);
    } catch (const cv::Exception&) {
        return; // three points that tell nothing
    }
    for (std::size_t i = 0; i < turns.size(); ++i) {
        const Eigen::Vector3d turn(turns[i].at<double>(0), turns[i].at<double>(1), turns[i].at<double>(2));
        PinholeCamera camera;
        camera.intrinsics = intrinsics;
        camera.translation = {shifts[i].at<double>(0), shifts[i].at<double>(1), shifts[i].at<double>(2)};
        if (turn.norm() > 0) camera.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized());
        if (camera.rotation.allFinite() && camera.translation.allFinite()) cameras.push_back(camera);
    }
}

struct Equations {
    Eigen::MatrixXd normal;   ///< JᵀJ
    Eigen::VectorXd gradient; ///< Jᵀr
    double squares = 0;       ///< infinite where a pair that counts is not before the camera
};

/// The normal equations of the reprojection errors, in pixels. With X = R·p + t the place is (fx·X/Z + cx,
/// fy·Y/Z + cy); `perPlace` is its derivative by X. The turn is a small one in front of R, exp([ω]×)·R, whose
/// derivative by ω at 0 is −[R·p]×, `perTurn`: three numbers without the bounds of angles or the constraint
/// of a quaternion. The focal length enters by its logarithm, so that no step can make it negative; a change
/// by s scales what lies off the principal point, (fx·x, fy·y).
///
/// A landmark behind the camera has an error that means nothing, as its place is mirrored: the step that led
/// there is refused.
Equations equationsAt(const PinholeCamera& camera, const std::vector<LandmarkPair>& pairs,
                      const std::vector<bool>& counts, Eigen::Index unknowns) {
    Equations equations{Eigen::MatrixXd::Zero(unknowns, unknowns), Eigen::VectorXd::Zero(unknowns), 0};
    const auto& [fx, fy, cx, cy] = camera.intrinsics;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (!counts[i]) continue;
        const Eigen::Vector3d turned = camera.rotation * pairs[i].organ, seen = turned + camera.translation;
        if (!(seen.z() > 0)) {
            equations.squares = std::numeric_limits<double>::infinity();
            return equations;
        }
        const double x = seen.x() / seen.z(), y = seen.y() / seen.z();
        const Eigen::Vector2d residual(fx * x + cx - pairs[i].photo.x(), fy * y + cy - pairs[i].photo.y());
        Eigen::Matrix<double, 2, 3> perPlace;
        perPlace << fx, 0, -fx * x, 0, fy, -fy * y;
        perPlace /= seen.z();
        Eigen::Matrix3d perTurn;
        perTurn << 0, turned.z(), -turned.y(), -turned.z(), 0, turned.x(), turned.y(), -turned.x(), 0;
        Eigen::MatrixXd jacobian(2, unknowns);
        jacobian.leftCols<3>() = perPlace * perTurn;
        jacobian.middleCols<3>(3) = perPlace;
        if (unknowns == 7) jacobian.col(6) << fx * x, fy * y; // by the focal length's logarithm
        equations.normal += jacobian.transpose() * jacobian;
        equations.gradient += jacobian.transpose() * residual;
        equations.squares += residual.squaredNorm();
    }
    return equations;
}

PinholeCamera moved(PinholeCamera camera, const Eigen::VectorXd& step) {
    const Eigen::Vector3d turn = step.head<3>();
    if (turn.norm() > 0)
        camera.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * camera.rotation;
    camera.translation += step.segment<3>(3);
    if (step.size() == 7) {
        const double factor = std::exp(std::clamp(step[6], -0.5, 0.5));
        camera.intrinsics.fx *= factor;
        camera.intrinsics.fy *= factor;
    }
    return camera;
}

} // namespace

std::vector<double> pairErrors(const PinholeCamera& camera, const std::vector<LandmarkPair>& pairs) {
    const auto& [fx, fy, cx, cy] = camera.intrinsics;
    std::vector<double> errors;
    for (const LandmarkPair& pair : pairs) {
        const Eigen::Vector3d seen = camera.rotation * pair.organ + camera.translation;
        const Eigen::Vector2d place(fx * seen.x() / seen.z() + cx, fy * seen.y() / seen.z() + cy);
        const double error = (place - pair.photo).norm();
        errors.push_back(seen.z() > 0 && std::isfinite(error) ? error
                                                              : std::numeric_limits<double>::infinity());
    }
    return errors;
}

/// Capped, so that one pair that was mixed up costs no more than any other that does not fit, and cannot
/// outweigh all that do (M-estimators; MSAC of Torr and Zisserman 2000).
double cappedSquares(const std::vector<double>& errors, double tolerance) {
    double sum = 0;
    for (const double error : errors)
        sum += std::pow(std::min(error, tolerance), 2);
    return sum;
}

std::vector<PinholeCamera> likelyCameras(const std::vector<LandmarkPair>& pairs, const Intrinsics& intrinsics,
                                         double tolerance, std::size_t count) {
    std::vector<PinholeCamera> cameras;
    for (const Triple3& triple : triplesOf(pairs.size()))
        addCamerasOf(triple, pairs, intrinsics, cameras);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < cameras.size(); ++i)
        order.emplace_back(cappedSquares(pairErrors(cameras[i], pairs), tolerance), i);
    std::sort(order.begin(), order.end());
    std::vector<PinholeCamera> best;
    for (std::size_t i = 0; i < std::min(count, order.size()); ++i)
        best.push_back(cameras[order[i].second]);
    return best;
}

/// Levenberg and Marquardt's method. Damping scales the diagonal instead of adding to it (Marquardt 1963), so
/// that turns, shifts and the focal length are held back alike, whatever their units. At the end (JᵀJ)⁻¹ is
/// the covariance for errors of one pixel; its last entry says how well the pairs tell the focal length:
/// hardly at all where they lie in one depth, since coming nearer and zooming then look the same.
PinholeCamera leastSquares(PinholeCamera start, const std::vector<LandmarkPair>& pairs,
                           const std::vector<bool>& counts, Freedom freedom, double* slack) {
    const Eigen::Index unknowns = freedom == Freedom::Pose ? 6 : 7;
    Equations here = equationsAt(start, pairs, counts, unknowns);
    double damping = firstDamping;
    for (int i = 0; i < mostSteps && damping < mostDamping && std::isfinite(here.squares); ++i) {
        Eigen::MatrixXd damped = here.normal;
        damped.diagonal() *= 1 + damping;
        const Eigen::VectorXd step = -damped.ldlt().solve(here.gradient);
        const PinholeCamera there = moved(start, step);
        const Equations next = equationsAt(there, pairs, counts, unknowns);
        if (!step.allFinite() || !(next.squares <= here.squares)) {
            damping *= 10;
            continue;
        }
        const double gained = here.squares - next.squares;
        start = there;
        here = next;
        if (gained <= 1e-14 * here.squares) break;
        damping = std::max(damping / 10, leastDamping);
    }
    if (slack && unknowns == 7) {
        const Eigen::VectorXd last = Eigen::VectorXd::Unit(unknowns, 6);
        const double variance = last.dot(here.normal.ldlt().solve(last));
        *slack = variance >= 0 ? std::sqrt(variance) : std::numeric_limits<double>::infinity();
    }
    return start;
}

} // namespace esm
