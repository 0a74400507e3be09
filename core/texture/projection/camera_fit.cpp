#include "core/texture/projection/camera_fit.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <limits>

namespace esm {

namespace {

/// Levenberg-Marquardt's damping, relative to the diagonal.
constexpr double firstDamping = 1e-3, leastDamping = 1e-12, mostDamping = 1e12;
constexpr int mostSteps = 100;

constexpr double longestLog = 0.5; ///< of a step of a logarithm

using Normal = Eigen::Matrix<double, camera_step::count, camera_step::count>;
using Free = std::array<bool, camera_step::count>;

Free freeNumbers(const CameraFreedom& freedom) {
    Free free{};
    std::fill(free.begin(), free.begin() + camera_step::focalLength, true);
    free[camera_step::focalLength] = freedom.focalLength;
    free[camera_step::principalPoint] = free[camera_step::principalPoint + 1] = freedom.principalPoint;
    free[camera_step::pixelAspect] = freedom.pixelAspect;
    return free;
}

struct Equations {
    Normal normal = Normal::Zero();            ///< JᵀJ
    CameraStep gradient = CameraStep::Zero();  ///< Jᵀr
    CameraStep curvature = CameraStep::Zero(); ///< of what is unusual
    double squares = 0, cost = 0;              ///< of the pairs alone, and of all; infinite where a pair that
                                               ///< counts is not before the camera
};

/// By one pair: with X = R·p + t the place is (fx·X/Z + cx, fy·Y/Z + cy); `perPlace` is its derivative by X.
/// The turn is a small one in front of R, exp([ω]×)·R, whose derivative by ω at 0 is −[R·p]×, `perTurn`:
/// three numbers without the bounds of angles or the constraint of a quaternion. A change of the focal
/// length's logarithm by s scales what lies off the principal point, (fx·x, fy·y); that of the aspect only
/// fx·x.
Eigen::Matrix<double, 2, camera_step::count>
derivative(const Intrinsics& camera, const Eigen::Vector3d& turned, const Eigen::Vector3d& seen) {
    const double x = seen.x() / seen.z(), y = seen.y() / seen.z();
    Eigen::Matrix<double, 2, 3> perPlace;
    perPlace << camera.fx, 0, -camera.fx * x, 0, camera.fy, -camera.fy * y;
    perPlace /= seen.z();
    Eigen::Matrix3d perTurn;
    perTurn << 0, turned.z(), -turned.y(), -turned.z(), 0, turned.x(), turned.y(), -turned.x(), 0;
    Eigen::Matrix<double, 2, camera_step::count> jacobian;
    jacobian.middleCols<3>(camera_step::turn) = perPlace * perTurn;
    jacobian.middleCols<3>(camera_step::shift) = perPlace;
    jacobian.col(camera_step::focalLength) << camera.fx * x, camera.fy * y;
    jacobian.middleCols<2>(camera_step::principalPoint).setIdentity();
    jacobian.col(camera_step::pixelAspect) << camera.fx * x, 0;
    return jacobian;
}

/// A landmark behind the camera has an error that means nothing, as its place is mirrored: the step that led
/// there is refused.
Equations equationsAt(const PinholeCamera& camera, const CameraProblem& problem, const Free& free,
                      double clickNoise) {
    Equations equations;
    const auto& [fx, fy, cx, cy] = camera.intrinsics;
    for (std::size_t i = 0; i < problem.pairs.size(); ++i) {
        if (!problem.counts[i]) continue;
        const LandmarkPair& pair = problem.pairs[i];
        const Eigen::Vector3d turned = camera.rotation * pair.organ, seen = turned + camera.translation;
        if (!(seen.z() > 0)) {
            equations.cost = std::numeric_limits<double>::infinity();
            return equations;
        }
        const Eigen::Vector2d residual(fx * seen.x() / seen.z() + cx - pair.photo.x(),
                                       fy * seen.y() / seen.z() + cy - pair.photo.y());
        const auto jacobian = derivative(camera.intrinsics, turned, seen);
        equations.normal += jacobian.transpose() * jacobian;
        equations.gradient += jacobian.transpose() * residual;
        equations.squares += residual.squaredNorm();
    }
    const Unlikeliness unusual = unlikeliness(problem.usual, camera.intrinsics);
    const double variance = clickNoise * clickNoise;
    equations.cost = equations.squares + variance * unusual.value;
    equations.gradient += variance * unusual.gradient;
    equations.curvature = variance * unusual.curvature;
    for (Eigen::Index i = 0; i < camera_step::count; ++i)
        if (!free[static_cast<std::size_t>(i)]) {
            equations.normal.row(i).setZero();
            equations.normal.col(i).setZero();
            equations.gradient[i] = 0;
            equations.curvature[i] = 1;
        }
    return equations;
}

Normal withCurvature(const Equations& equations) {
    Normal all = equations.normal;
    all.diagonal() += equations.curvature;
    return all;
}

/// Levenberg and Marquardt's method. Damping scales the diagonal instead of adding to it (Marquardt 1963), so
/// that turns, shifts and lengths are held back alike, whatever their units.
PinholeCamera descended(PinholeCamera camera, const CameraProblem& problem, const Free& free,
                        double clickNoise) {
    Equations here = equationsAt(camera, problem, free, clickNoise);
    double damping = firstDamping;
    for (int i = 0; i < mostSteps && damping < mostDamping && std::isfinite(here.cost); ++i) {
        Normal damped = withCurvature(here);
        damped.diagonal() *= 1 + damping;
        CameraStep step = -damped.ldlt().solve(here.gradient);
        for (const Eigen::Index logarithm : {camera_step::focalLength, camera_step::pixelAspect})
            step[logarithm] = std::clamp(step[logarithm], -longestLog, longestLog);
        const PinholeCamera there = moved(camera, step);
        const Equations next = equationsAt(there, problem, free, clickNoise);
        if (!step.allFinite() || !(next.cost <= here.cost)) {
            damping *= 10;
            continue;
        }
        const double gained = here.cost - next.cost;
        camera = there;
        here = next;
        if (gained <= 1e-14 * here.cost) break;
        damping = std::max(damping / 10, leastDamping);
    }
    return camera;
}

} // namespace

int unknownsOf(const CameraFreedom& freedom) {
    return 6 + int{freedom.focalLength} + 2 * int{freedom.principalPoint} + int{freedom.pixelAspect};
}

double usualClickNoise(PhotoSize photo) {
    return 5e-4 * std::hypot(photo.width, photo.height);
}

/// The noise is the squares of the errors by the equations that the unknowns leave. An unknown takes as much
/// of an equation as the pairs tell it: with N = JᵀJ and what is usual, N + P, together they take
/// tr((N + P)⁻¹ N) (MacKay 1992, Bayesian interpolation). One error of the usual size is added to those that
/// are left, since few of them may be small by chance.
CameraFit fitCamera(PinholeCamera start, const CameraProblem& problem, const CameraFreedom& freedom,
                    int rounds) {
    const Free free = freeNumbers(freedom);
    const auto counting = static_cast<double>(std::count(problem.counts.begin(), problem.counts.end(), true));
    CameraFit fit{start, problem.usualNoise, 0, {}};
    for (int round = 0; round < rounds; ++round) {
        fit.camera = descended(fit.camera, problem, free, fit.clickNoise);
        const Equations here = equationsAt(fit.camera, problem, free, fit.clickNoise);
        const Normal all = withCurvature(here);
        fit.precision = all / (fit.clickNoise * fit.clickNoise);
        fit.told = all.ldlt().solve(here.normal).trace();
        fit.clickNoise = std::sqrt((here.squares + std::pow(problem.usualNoise, 2)) /
                                   std::max(1.0, 2 * counting + 1 - fit.told));
    }
    return fit;
}

} // namespace esm
