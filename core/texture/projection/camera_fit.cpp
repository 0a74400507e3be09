#include "core/texture/projection/camera_fit.h"

#include "core/texture/projection/damped_descent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Cholesky>
#include <limits>
#include <numeric>

namespace esm {

namespace {

constexpr DescentLimits fitLimits{100, 1e-14, 1e12};

constexpr double longestLog = 0.5; ///< of a step of a logarithm

using Normal = Eigen::Matrix<double, camera_step::count, camera_step::count>;
using Free = std::array<bool, camera_step::count>;

Free marked(const std::vector<Eigen::Index>& numbers) {
    Free free{};
    for (const Eigen::Index number : numbers)
        free[static_cast<std::size_t>(number)] = true;
    return free;
}

struct Equations {
    Normal normal = Normal::Zero();            ///< JᵀJ and, on the diagonal, the curvature
    CameraStep gradient = CameraStep::Zero();  ///< Jᵀr, with that of what is unusual
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
    equations.normal.diagonal() += equations.curvature;
    return equations;
}

PinholeCamera movedWithin(const PinholeCamera& camera, CameraStep step) {
    for (const Eigen::Index logarithm : {camera_step::focalLength, camera_step::pixelAspect})
        step[logarithm] = std::clamp(step[logarithm], -longestLog, longestLog);
    return moved(camera, step);
}

} // namespace

std::vector<Eigen::Index> numbersOf(CameraPart part) {
    switch (part) {
    case CameraPart::FocalLength:
        return {camera_step::focalLength};
    case CameraPart::PrincipalPoint:
        return {camera_step::principalPoint, camera_step::principalPoint + 1};
    case CameraPart::PixelAspect:
        return {camera_step::pixelAspect};
    }
    return {};
}

std::vector<Eigen::Index> freeNumbers(const CameraFreedom& freedom) {
    std::vector<Eigen::Index> numbers(camera_step::focalLength); // those of the pose
    std::iota(numbers.begin(), numbers.end(), Eigen::Index{0});
    for (const auto& [part, isFree] : {std::pair(CameraPart::FocalLength, freedom.focalLength),
                                       {CameraPart::PrincipalPoint, freedom.principalPoint},
                                       {CameraPart::PixelAspect, freedom.pixelAspect}}) {
        const std::vector<Eigen::Index> ofPart = isFree ? numbersOf(part) : std::vector<Eigen::Index>();
        numbers.insert(numbers.end(), ofPart.begin(), ofPart.end());
    }
    return numbers;
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
    const Free free = marked(freeNumbers(freedom));
    const auto counting = static_cast<double>(std::count(problem.counts.begin(), problem.counts.end(), true));
    CameraFit fit{start, problem.usualNoise, 0, {}};
    for (int round = 0; round < rounds; ++round) {
        const auto equations = [&](const PinholeCamera& camera) {
            return equationsAt(camera, problem, free, fit.clickNoise);
        };
        fit.camera = descended(fit.camera, equations, movedWithin, fitLimits);
        const Equations here = equations(fit.camera);
        Normal ofPairs = here.normal;
        ofPairs.diagonal() -= here.curvature;
        fit.precision = here.normal / (fit.clickNoise * fit.clickNoise);
        fit.told = here.normal.ldlt().solve(ofPairs).trace();
        fit.clickNoise = std::sqrt((here.squares + std::pow(problem.usualNoise, 2)) /
                                   std::max(1.0, 2 * counting + 1 - fit.told));
    }
    return fit;
}

} // namespace esm
