#include "core/dynamics/spectrum/definite_step.h"

#include "core/dynamics/spectrum/lanczos.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace esm {

namespace {

using Matrix = Eigen::SparseMatrix<double>;

double form(const Matrix& matrix, const Eigen::VectorXd& x) {
    return x.dot(matrix.selfadjointView<Eigen::Lower>() * x);
}

double form(const SymmetricSum& matrix, const Eigen::VectorXd& x) {
    return x.dot(matrix.times(x));
}

/// What each row of Q is multiplied with, from both sides: one over the root of all on its diagonal that
/// makes Q larger. Parts of the tissue that differ by orders of magnitude then weigh alike. Scaling from both
/// sides changes no sign of Q's eigenvalues (Sylvester) but brings them close together. The one next to zero
/// is then a larger part of the spectrum and sooner found.
Eigen::VectorXd scaleOf(const StepFamily& family, double h) {
    Eigen::VectorXd scale = family.factors.mass * family.mass.diagonal();
    scale += std::max(0.0, family.factors.damping * h) * family.damping.diagonal();
    scale += std::max(0.0, family.factors.stiffness * h * h) * family.stiffness.diagonal();
    return scale.cwiseSqrt().cwiseInverse();
}

enum class Verdict { Definite, Indefinite, Open };

struct Trial {
    Verdict verdict;
    Eigen::VectorXd motion; ///< for which Q is negative, where it is indefinite
};

/// −Q(h), scaled.
SymmetricSum scaledNegative(const StepFamily& family, double h, const Eigen::VectorXd& scale) {
    const MatrixFactors& factors = family.factors;
    const double stiffness = factors.stiffness * h * h;
    const Matrix sum = factors.mass * family.mass + factors.damping * h * family.damping +
                       stiffness * family.stiffness.lower;
    return scaled({-sum, family.stiffness.columns, -stiffness * family.stiffness.factor}, scale);
}

/// Q(h) is definite where the largest eigenvalue of its scaled negative is below zero. `ask` is called now
/// and then.
///
/// The two answers are not alike. A Ritz value above zero is itself some xᵀ·(−Q)·x: that proves Q indefinite,
/// and what is still waited for is a better x. A Ritz value below zero proves nothing, since Lanczos' method
/// may not have met the largest eigenvalue yet; it counts only after so many iterations that one which stands
/// out by the tolerance would hardly have escaped. Where neither comes within four times as many, Q is nearly
/// singular, and a shorter step is easier to judge.
Trial tryStep(const StepFamily& family, double h, double tolerance, const std::function<void()>& ask) {
    const Eigen::VectorXd scale = scaleOf(family, h);
    const SymmetricSum matrix = scaledNegative(family, h, scale);
    const Eigen::VectorXd start = arbitraryDirection(matrix.rows());
    const int least = iterationsToNotice(tolerance, matrix.rows());
    const auto isEnough = [&](const RitzPair& pair) {
        ask();
        if (pair.value > 0) return pair.residual < std::max(0.25 * tolerance, 0.1 * pair.value);
        return pair.value + pair.residual < 0 && pair.coefficients.size() >= least;
    };
    const RitzPair pair = largestRitzPair(matrix, start, {isEnough, 1, 4 * least});
    if (pair.value > 0) return {Verdict::Indefinite, scale.cwiseProduct(ritzVector(pair, matrix, start))};
    return {pair.value + pair.residual < 0 ? Verdict::Definite : Verdict::Open, {}};
}

} // namespace

// The smallest positive root of a + b·h + c·h² with a > 0, written so that nothing cancels.
double firstZero(const StepFamily& family, const Eigen::VectorXd& x) {
    const double a = family.factors.mass * form(family.mass, x),
                 b = family.factors.damping * form(family.damping, x),
                 c = family.factors.stiffness * form(family.stiffness, x);
    const double discriminant = b * b - 4 * a * c;
    const double divisor = discriminant < 0 ? 0 : std::sqrt(discriminant) - b;
    return divisor > 0 ? 2 * a / divisor : std::numeric_limits<double>::infinity();
}

// The limit is the least first zero of all motions: any motion bounds it from above. At a step that is too
// long, take the motion that Q is most negative for. If it is a little off the limit's own motion, its first
// zero is off the limit by the square of that, as with Rayleigh's quotient; so a few such motions lead there.
// A step shorter by the tolerance is then shown to be definite. All of it takes products with the matrices,
// no factorisation: time in proportion to their size.
//
// Where a step can be shown neither to be definite nor not to be, the share by which the next is shorter is
// squared. The answer then loses some of its length, never its safety.
double largestDefiniteStep(const StepFamily& family, const Eigen::VectorXd& near,
                           const DefiniteSearch& search) {
    if (search.sure >= search.cap) return search.cap;
    const double first = near.size() > 0 ? firstZero(family, near) : search.cap;
    double bound = std::min(search.cap, first), shrink = 1 + search.tolerance;
    if (!std::isfinite(bound)) return bound;
    double trial = bound < search.cap ? bound / shrink : bound;
    for (int tries = 0; bound > (1 + search.tolerance) * search.sure; ++tries) {
        trial = std::max(trial, search.sure);
        const auto ask = [&] { reportProgress(search.progress, 1 - 1 / (1 + 0.1 * tries)); };
        const Trial tried = tryStep(family, trial, search.tolerance, ask);
        if (tried.verdict == Verdict::Definite) return trial;
        bound = trial;
        if (tried.verdict == Verdict::Indefinite) bound = std::min(bound, firstZero(family, tried.motion));
        if (tried.verdict == Verdict::Open) shrink *= shrink;
        trial = bound / shrink;
    }
    return std::min(search.sure, search.cap);
}

// With nothing positive beside its diagonal, A = h·D − share·M is positive definite exactly where some
// positive v has A·v > 0 (it is then an M-matrix, Berman and Plemmons 1979). Conjugate gradients towards A·v
// = M·1 either come to such a v or past a direction in which A is not positive; where they do neither for
// long, the answer is the careful one.
bool isDampedBeyond(double share, double h, const Eigen::SparseMatrix<double>& mass,
                    const Eigen::SparseMatrix<double>& damping) {
    constexpr int mostIterations = 1000;
    const Matrix matrix = h * damping - share * mass;
    const Eigen::VectorXd diagonal = matrix.diagonal(), wanted = mass.diagonal();
    if (!(diagonal.minCoeff() > 0)) return false;
    Eigen::VectorXd v = Eigen::VectorXd::Zero(wanted.size()), residual = wanted;
    // Where all that moves moves alike, springs do not damp.
    Eigen::VectorXd direction = Eigen::VectorXd::Ones(wanted.size());
    if (!(form(matrix, direction) > 0)) return false;
    direction = residual.cwiseQuotient(diagonal);
    double weight = residual.dot(direction);
    for (int iteration = 0; iteration < mostIterations; ++iteration) {
        const Eigen::VectorXd product = matrix.selfadjointView<Eigen::Lower>() * direction;
        const double curvature = direction.dot(product);
        if (!(curvature > 0)) return false;
        v += weight / curvature * direction;
        residual -= weight / curvature * product;
        if (v.minCoeff() > 0 && (wanted - residual).minCoeff() > 0) return true;
        const double former = std::exchange(weight, residual.dot(residual.cwiseQuotient(diagonal)));
        direction = residual.cwiseQuotient(diagonal) + weight / former * direction;
    }
    return false;
}

} // namespace esm
