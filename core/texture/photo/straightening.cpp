#include "core/texture/photo/straightening.h"

#include "core/support/errors.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

namespace {

using Residuals = Eigen::VectorXd;

/// The bent radius over the focal length that a straight one comes to, and how fast it grows.
struct BentRadius {
    double value, slope;
};

BentRadius bentRadius(const Lens& lens, double straight) {
    const auto& c = lens.coefficients;
    const bool isFisheye = lens.kind == LensKind::Fisheye;
    const double r = isFisheye ? std::atan(straight) : straight, s = r * r;
    const double third = isFisheye ? c[2] : c[4], fourth = isFisheye ? c[3] : 0;
    const double slope = 1 + s * (3 * c[0] + s * (5 * c[1] + s * (7 * third + s * 9 * fourth)));
    return {r * (1 + s * (c[0] + s * (c[1] + s * (third + s * fourth)))),
            isFisheye ? slope / (1 + straight * straight) : slope};
}

/// Newton's method, inside the bracket that bisection keeps: fast near the root, and safe where the slope is
/// small. The bracket grows by half until it holds the radius. Where the curve turns back before it does, the
/// lens shows nothing that far out: NaN. Twelve times are enough for a factor of 130, and end a search that
/// would go on for ever.
double straightRadius(const Lens& lens, double bent) {
    double low = 0, high = std::max(bent, 1e-9);
    for (int i = 0; bentRadius(lens, high).value < bent; ++i) {
        if (i == 12 || !(bentRadius(lens, high).slope > 0)) return std::numeric_limits<double>::quiet_NaN();
        low = high;
        high *= 1.5;
    }
    double radius = std::clamp(bent, low, high);
    for (int i = 0; i < 60 && high - low > 1e-14 * high; ++i) {
        const BentRadius at = bentRadius(lens, radius);
        (at.value < bent ? low : high) = radius;
        const double next = radius - (at.value - bent) / at.slope;
        radius = next > low && next < high ? next : 0.5 * (low + high);
    }
    return radius;
}

/// Distances of a line's places from the straight line nearest to them, in pixels of the photo. That line
/// goes through their mean along the direction in which they spread most; the eigenvector of the smaller
/// eigenvalue is its normal (total least squares, which knows no steep lines).
void addDistances(const Lens& lens, const DrawnLine& line, Residuals& residuals, Eigen::Index& next) {
    const auto count = static_cast<Eigen::Index>(line.size());
    Eigen::MatrixX2d places(count, 2);
    for (Eigen::Index i = 0; i < count; ++i)
        places.row(i) = straightened(lens, line[static_cast<std::size_t>(i)]).transpose();
    const Eigen::RowVector2d mean = places.colwise().mean();
    places.rowwise() -= mean;
    const Eigen::Matrix2d spread = places.transpose() * places;
    const Eigen::Vector2d across =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(0);
    const Eigen::Vector2d centre(lens.camera.cx, lens.camera.cy);
    for (Eigen::Index i = 0; i < count; ++i) {
        const double bent = (line[static_cast<std::size_t>(i)] - centre).norm();
        const double straight = (places.row(i) + mean - centre.transpose()).norm();
        // What the lens shrinks at this place; else the lens that shrinks most would fit best.
        const double shrinks = straight > 1e-9 ? bent / straight : 1;
        residuals[next++] = shrinks * places.row(i).dot(across);
    }
}

Residuals residualsOf(const Lens& lens, const std::vector<DrawnLine>& lines) {
    std::size_t count = 0;
    for (const DrawnLine& line : lines)
        count += line.size();
    Residuals residuals(static_cast<Eigen::Index>(count));
    Eigen::Index next = 0;
    for (const DrawnLine& line : lines)
        addDistances(lens, line, residuals, next);
    return residuals;
}

double squareError(const Residuals& residuals) {
    return residuals.allFinite() ? residuals.squaredNorm() : std::numeric_limits<double>::infinity();
}

/// One column per coefficient.
Eigen::MatrixXd slopesOf(const Lens& lens, const std::vector<DrawnLine>& lines, int coefficients) {
    constexpr double step = 1e-6;
    Eigen::MatrixXd slopes;
    for (int i = 0; i < coefficients; ++i) {
        const auto moved = [&](double by) {
            Lens other = lens;
            other.coefficients[static_cast<std::size_t>(i)] += by;
            return residualsOf(other, lines);
        };
        const Residuals slope = (moved(step) - moved(-step)) / (2 * step);
        if (slopes.size() == 0) slopes.resize(slope.size(), coefficients);
        slopes.col(i) = slope;
    }
    return slopes;
}

/// Levenberg and Marquardt's method: Gauss and Newton's step, shortened by damping until it lowers the error,
/// and more daring after each that does. Slopes are differences, since each residual goes through an
/// eigenvector and the inverse of a polynomial. @returns the slopes at the end
Eigen::MatrixXd solveCoefficients(Lens& lens, const std::vector<DrawnLine>& lines, int coefficients) {
    double damping = 1e-3;
    Residuals residuals = residualsOf(lens, lines);
    for (int i = 0; i < 100; ++i) {
        const Eigen::MatrixXd slopes = slopesOf(lens, lines, coefficients);
        Eigen::MatrixXd normal = slopes.transpose() * slopes;
        normal.diagonal() += damping * normal.diagonal();
        const Eigen::VectorXd change = normal.ldlt().solve(-slopes.transpose() * residuals);
        if (!change.allFinite()) break;
        Lens tried = lens;
        for (int k = 0; k < coefficients; ++k)
            tried.coefficients[static_cast<std::size_t>(k)] += change[k];
        const Residuals left = residualsOf(tried, lines);
        if (squareError(left) >= squareError(residuals)) {
            if (damping > 1e9) break;
            damping *= 10;
            continue;
        }
        lens = tried;
        residuals = left;
        damping = std::max(1e-9, damping / 10);
        if (change.norm() < 1e-10) break;
    }
    return slopesOf(lens, lines, coefficients);
}

/// How far, in pixels at the photo's corner, places that are drawn a pixel off may lead the lens astray. The
/// coefficients' covariance for errors of one pixel is (JᵀJ)⁻¹; what matters is not a coefficient but how far
/// it moves the corner, where both add up.
double uncertainty(const Eigen::MatrixXd& slopes, double cornerRadius) {
    if (!slopes.allFinite()) return std::numeric_limits<double>::infinity();
    const Eigen::MatrixXd normal = slopes.transpose() * slopes;
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(normal);
    if (!lu.isInvertible()) return std::numeric_limits<double>::infinity();
    // At the corner, a focal length from the middle, every coefficient counts one.
    const Eigen::VectorXd corner = Eigen::VectorXd::Ones(normal.rows());
    return cornerRadius * std::sqrt(std::max(0.0, corner.dot(lu.solve(corner))));
}

/// Whether the straight picture shows no place of the photo twice, up to its corner: the bent radius must
/// grow all the way. A polynomial that fits the lines may turn back beyond them.
bool bendsNothingBack(const Lens& lens) {
    constexpr int steps = 100;
    for (int i = 0; i <= steps; ++i)
        if (!(bentRadius(lens, static_cast<double>(i) / steps).slope > 0)) return false;
    return true;
}

} // namespace

Eigen::Vector2d straightened(const Lens& lens, const Eigen::Vector2d& place) {
    const Eigen::Array2d focal(lens.camera.fx, lens.camera.fy), centre(lens.camera.cx, lens.camera.cy);
    const Eigen::Vector2d bent = (place.array() - centre) / focal;
    const double radius = bent.norm();
    if (radius < 1e-12) return place;
    return (bent.array() * (straightRadius(lens, radius) / radius)) * focal + centre;
}

double bending(const Lens& lens, const std::vector<DrawnLine>& lines) {
    const Residuals residuals = residualsOf(lens, lines);
    return residuals.size() > 0 ? std::sqrt(residuals.squaredNorm() / static_cast<double>(residuals.size()))
                                : 0;
}

/// The lens that explains most is tried first, and given up for the simpler one where the lines do not
/// determine it: lines near the middle hardly bend, and a second coefficient then only follows the hand that
/// drew them.
Lens straighteningLens(LensKind kind, const PhotoSize& size, const std::vector<DrawnLine>& lines) {
    std::vector<DrawnLine> usable;
    std::copy_if(lines.begin(), lines.end(), std::back_inserter(usable),
                 [](const DrawnLine& line) { return line.size() >= 3; });
    if (usable.size() < 2)
        throw InvalidModel(
            "two lines of three places each are needed to straighten the photo; draw more along "
            "what should be straight");
    const double half = 0.5 * std::hypot(size.width, size.height);
    Lens lens{kind, {half, half, 0.5 * size.width, 0.5 * size.height}, {}};
    constexpr double mostUncertain = 0.1; // of half the diagonal
    for (int coefficients = usable.size() >= 3 ? 2 : 1; coefficients >= 1; --coefficients) {
        Lens found = lens;
        const Eigen::MatrixXd slopes = solveCoefficients(found, usable, coefficients);
        if (uncertainty(slopes, half) <= mostUncertain * half && bendsNothingBack(found)) return found;
    }
    throw InvalidModel(
        "the lines do not tell how the lens bends; draw long ones near the photo's border, not "
        "through its middle, with places all along them");
}

} // namespace esm
