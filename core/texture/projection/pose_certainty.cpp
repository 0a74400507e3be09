#include "core/texture/projection/pose_certainty.h"

#include "core/support/angles.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <limits>
#include <numeric>
#include <random>

namespace esm {

namespace {

constexpr double probability = 0.95;
constexpr int rounds = 5, perRound = 3000;
constexpr double tailFreedom = 5; ///< of the Student's distribution that is drawn from

/// Student's distribution in the unknowns: normal in the middle, with tails that no truth outruns.
struct Proposal {
    Eigen::VectorXd middle;
    Eigen::MatrixXd spread; ///< its Cholesky factor L, a draw being middle + L z
    double logDeterminant = 0;

    Proposal(Eigen::VectorXd at, const Eigen::MatrixXd& covariance) : middle(std::move(at)) {
        spread = covariance.llt().matrixL();
        logDeterminant = spread.diagonal().array().log().sum();
    }

    bool isUsable() const { return spread.allFinite() && std::isfinite(logDeterminant); }

    Eigen::VectorXd draw(std::mt19937_64& random) const {
        std::normal_distribution<double> normal;
        std::chi_squared_distribution<double> chiSquared(tailFreedom);
        Eigen::VectorXd z(middle.size());
        for (double& value : z)
            value = normal(random);
        return middle + spread * z * std::sqrt(tailFreedom / chiSquared(random));
    }

    double logDensity(const Eigen::VectorXd& at) const {
        const auto dimensions = static_cast<double>(middle.size());
        const double squared =
            spread.triangularView<Eigen::Lower>().solve(at - middle).squaredNorm() / tailFreedom;
        return -logDeterminant - (tailFreedom + dimensions) / 2 * std::log1p(squared);
    }
};

/// The logarithm of how likely a camera is, the pairs seen: the noise of the clicks being unknown as well, it
/// is taken out by its own likelihoods, with one error of the usual size seen before (Gelman et al.,
/// Bayesian Data Analysis, 3.2).
double logLikelihood(const PinholeCamera& camera, const CameraProblem& problem) {
    double squares = std::pow(problem.usualNoise, 2), equations = 1;
    const std::vector<double> errors = pairErrors(camera, problem.pairs);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (!problem.counts[i]) continue;
        squares += errors[i] * errors[i];
        equations += 2;
    }
    return -equations / 2 * std::log(squares) - unlikeliness(problem.usual, camera.intrinsics).value / 2;
}

struct Draws {
    Eigen::MatrixXd unknowns; ///< one draw a column
    Eigen::VectorXd weights;  ///< sum to 1
};

/// How often draws of one weight tell as much (Kong 1992).
double effectiveCount(const Draws& draws) {
    return 1 / draws.weights.squaredNorm();
}

class CameraSampler {
public:
    CameraSampler(const CameraFit& fit, const CameraProblem& problem, const CameraFreedom& unknown)
        : m_fit(fit), m_problem(problem), m_numbers(freeNumbers(unknown)) {}

    /// Importance sampling from a distribution that is fitted to its own draws, round by round (Cappé et al.
    /// 2004, Population Monte Carlo): how the depth and the focal length hang together is bent, and no normal
    /// distribution.
    Draws draws() {
        Proposal proposal(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(m_numbers.size())),
                          4 * covariance()); // wide, so that no tail is missed
        Draws last;
        for (int round = 0; round < rounds && proposal.isUsable(); ++round) {
            last = drawn(proposal);
            if (effectiveCount(last) > 4 * static_cast<double>(m_numbers.size())) proposal = fitted(last);
        }
        return last;
    }

    PinholeCamera camera(const Eigen::VectorXd& unknowns) const {
        CameraStep step = CameraStep::Zero();
        for (std::size_t i = 0; i < m_numbers.size(); ++i)
            step[m_numbers[i]] = unknowns[static_cast<Eigen::Index>(i)];
        return moved(m_fit.camera, step);
    }

private:
    Eigen::MatrixXd covariance() const {
        const Eigen::MatrixXd precision = m_fit.precision(m_numbers, m_numbers);
        return precision.llt().solve(Eigen::MatrixXd::Identity(precision.rows(), precision.cols()));
    }

    Draws drawn(const Proposal& proposal) {
        Draws draws;
        draws.unknowns.resize(proposal.middle.size(), perRound);
        draws.weights.resize(perRound);
        for (Eigen::Index i = 0; i < perRound; ++i) {
            draws.unknowns.col(i) = proposal.draw(m_random);
            const Eigen::VectorXd at = draws.unknowns.col(i);
            draws.weights[i] = logLikelihood(camera(at), m_problem) - proposal.logDensity(at);
        }
        draws.weights = (draws.weights.array() - draws.weights.maxCoeff()).exp();
        draws.weights /= draws.weights.sum();
        return draws;
    }

    static Proposal fitted(const Draws& draws) {
        const Eigen::VectorXd middle = draws.unknowns * draws.weights;
        const Eigen::MatrixXd off = draws.unknowns.colwise() - middle;
        return {middle, off * draws.weights.asDiagonal() * off.transpose()};
    }

    const CameraFit& m_fit;
    const CameraProblem& m_problem;
    std::vector<Eigen::Index> m_numbers;
    std::mt19937_64 m_random{1};
};

/// Below which the given share of the weights lies.
double quantile(const std::vector<double>& values, const Eigen::VectorXd& weights) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    double below = 0;
    for (const std::size_t i : order) {
        below += weights[static_cast<Eigen::Index>(i)];
        if (below >= probability) return values[i];
    }
    return std::numeric_limits<double>::infinity();
}

} // namespace

PoseCertainty poseCertainty(const CameraFit& fit, const CameraProblem& problem, const CameraFreedom& unknown,
                            const PinholeCamera& used) {
    CameraSampler sampler(fit, problem, unknown);
    const Draws draws = sampler.draws();
    std::vector<double> eyes, turns;
    for (Eigen::Index i = 0; i < draws.unknowns.cols(); ++i) {
        const PinholeCamera camera = sampler.camera(draws.unknowns.col(i));
        eyes.push_back((camera.eye() - used.eye()).norm());
        turns.push_back(toDegrees(Eigen::AngleAxisd(camera.rotation * used.rotation.transpose()).angle()));
    }
    return {quantile(eyes, draws.weights), quantile(turns, draws.weights)};
}

} // namespace esm
