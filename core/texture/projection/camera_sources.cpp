#include "core/texture/projection/camera_sources.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>

namespace esm {

namespace {

/// The largest share that the variance of a found part has of what is usual alone.
constexpr double foundShare = 0.25;

/// Of χ² with one and two degrees of freedom, 99 %.
constexpr double surelyOne = 6.63, surelyTwo = 9.21;

Eigen::MatrixXd covarianceOf(const Eigen::MatrixXd& precision) {
    return precision.ldlt().solve(Eigen::MatrixXd::Identity(precision.rows(), precision.cols()));
}

/// How unsure eye and turn are: variances, all directions together. The eye −Rᵀt moves by −Rᵀ (δ + t × ω) for
/// a shift δ and a turn ω.
struct PoseVariance {
    double eye, turn;
};

PoseVariance varianceOf(const CameraFit& fit, const Eigen::MatrixXd& precision) {
    const Eigen::MatrixXd covariance = covarianceOf(precision);
    const Eigen::Vector3d& t = fit.camera.translation;
    Eigen::Matrix<double, 3, 6> eye;
    eye << 0, -t.z(), t.y(), 1, 0, 0, t.z(), 0, -t.x(), 0, 1, 0, -t.y(), t.x(), 0, 0, 0, 1;
    return {(eye * covariance.topLeftCorner<6, 6>() * eye.transpose()).trace(),
            covariance.topLeftCorner<3, 3>().trace()};
}

/// As if these parts were known.
PoseVariance varianceKnowing(const CameraFit& fit, const std::vector<CameraPart>& parts) {
    Eigen::MatrixXd precision = fit.precision;
    for (const CameraPart part : parts)
        for (const Eigen::Index i : numbersOf(part)) {
            precision.row(i).setZero();
            precision.col(i).setZero();
            precision(i, i) = 1;
        }
    return varianceOf(fit, precision);
}

} // namespace

CameraSources sourcesOf(const CameraFit& whole, const UsualCamera& usual) {
    const Eigen::VectorXd variance = covarianceOf(whole.precision).diagonal();
    const CameraStep known = unlikeliness(usual, whole.camera.intrinsics).curvature;
    const auto isFound = [&](Eigen::Index i) { return variance[i] * known[i] < foundShare; };
    const auto sourceIf = [](bool found) { return found ? PartSource::Found : PartSource::Assumed; };
    CameraSources sources(PartSource::Assumed);
    sources.focalLength = sourceIf(isFound(camera_step::focalLength));
    sources.principalPoint =
        sourceIf(isFound(camera_step::principalPoint) && isFound(camera_step::principalPoint + 1));
    sources.pixelAspect = sourceIf(isFound(camera_step::pixelAspect));
    return sources;
}

CameraFreedom oddParts(const CameraFit& whole, const UsualCamera& usual, const CameraSources& sources) {
    const Eigen::MatrixXd covariance = covarianceOf(whole.precision);
    const Intrinsics& camera = whole.camera.intrinsics;
    const Eigen::Vector2d off(camera.cx - usual.camera.cx, camera.cy - usual.camera.cy);
    const Eigen::Matrix2d spread =
        covariance.block<2, 2>(camera_step::principalPoint, camera_step::principalPoint);
    const double stretched = std::log(camera.fx / camera.fy);
    const double aspectVariance = covariance(camera_step::pixelAspect, camera_step::pixelAspect);
    CameraFreedom odd = poseAndFocalLength;
    odd.principalPoint =
        sources.principalPoint == PartSource::Found && off.dot(spread.ldlt().solve(off)) > surelyTwo;
    odd.pixelAspect =
        sources.pixelAspect == PartSource::Found && stretched * stretched > surelyOne * aspectVariance;
    return odd;
}

PinholeCamera withUsualParts(PinholeCamera camera, const UsualCamera& usual, const CameraFreedom& free) {
    if (!free.principalPoint) {
        camera.intrinsics.cx = usual.camera.cx;
        camera.intrinsics.cy = usual.camera.cy;
    }
    if (!free.pixelAspect) camera.intrinsics.fx = camera.intrinsics.fy;
    return camera;
}

std::optional<CameraPart> dominatingAssumption(const CameraFit& whole, const CameraSources& sources) {
    const PoseVariance all = varianceOf(whole, whole.precision);
    const auto left = [&](const std::vector<CameraPart>& parts) {
        const PoseVariance known = varianceKnowing(whole, parts);
        return std::min(known.eye / all.eye, known.turn / all.turn);
    };
    std::vector<CameraPart> assumed;
    for (const auto& [part, source] : {std::pair(CameraPart::FocalLength, sources.focalLength),
                                       {CameraPart::PrincipalPoint, sources.principalPoint},
                                       {CameraPart::PixelAspect, sources.pixelAspect}})
        if (source == PartSource::Assumed) assumed.push_back(part);
    if (assumed.empty() || left(assumed) >= 0.5) return std::nullopt;
    return *std::min_element(assumed.begin(), assumed.end(),
                             [&](CameraPart a, CameraPart b) { return left({a}) < left({b}); });
}

} // namespace esm
