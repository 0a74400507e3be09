#include "core/dynamics/spectrum/definite_step.h"
#include "tests/support/tissue_models.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>

using namespace esm;

namespace {

constexpr double tolerance = 1e-3;

struct Matrices {
    Eigen::SparseMatrix<double> mass, damping, stiffness;
};

Matrices matricesOf(const TissueModel& model) {
    const SpringSystem system = makeSpringSystem(model);
    const auto matrix = [&](const MatrixFactors& factors) {
        return laplacianMatrix(system, factors, system.fixed);
    };
    return {matrix({1, 0, 0}), matrix({0, 1, 0}), matrix({0, 0, 1})};
}

/// A membrane whose nodes differ by orders of magnitude, stiffness and viscosity not alike.
TissueModel unevenMembrane(double spread) {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(9, 0.1), {50, 0.5, 0.001});
    for (std::size_t i = 0; i < model.mass.size(); ++i) {
        model.springConstant[i] *= std::exp(spread * std::sin(1.7 * static_cast<double>(i)));
        model.viscosity[i] *= std::exp(spread * std::cos(2.9 * static_cast<double>(i)));
        model.mass[i] *= std::exp(spread / 2 * std::sin(4.1 * static_cast<double>(i)));
    }
    model.tethers = {{3, 500, 0.01}, {40, 1, 30}};
    return model;
}

Eigen::MatrixXd dense(const Eigen::SparseMatrix<double>& lower) {
    return Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
}

Eigen::MatrixXd dense(const SymmetricSum& sum) {
    Eigen::MatrixXd result = dense(sum.lower);
    if (sum.columns.cols() > 0) result += sum.factor * sum.columns * sum.columns.transpose();
    return result;
}

bool isDefinite(const StepFamily& family, double h) {
    const MatrixFactors& factors = family.factors;
    const Eigen::MatrixXd sum = factors.mass * dense(family.mass) +
                                factors.damping * h * dense(family.damping) +
                                factors.stiffness * h * h * dense(family.stiffness);
    return sum.llt().info() == Eigen::Success;
}

/// By halving, with a dense factorisation at each try.
double exactLimit(const StepFamily& family, double definite, double indefinite) {
    for (int i = 0; i < 60; ++i) {
        const double middle = std::sqrt(definite * indefinite);
        (isDefinite(family, middle) ? definite : indefinite) = middle;
    }
    return definite;
}

Eigen::VectorXd alternating(Eigen::Index size) {
    Eigen::VectorXd motion(size);
    for (Eigen::Index i = 0; i < size; ++i)
        motion[i] = i % 2 == 0 ? 1 : -1;
    return motion;
}

} // namespace

TEST(LargestDefiniteStep, IsShortOfTheLimitByAtMostTheTolerance) {
    for (const double spread : {0.0, 1.0, 4.0})
        for (const MatrixFactors& factors :
             {MatrixFactors{4, -2, -1}, {4, 2, -1}, {16.0 / 3, 4.0 / 3, -1}, {7.7, -2.8, 0}}) {
            SCOPED_TRACE(testing::Message() << "spread " << spread << ", damping " << factors.damping);
            const Matrices matrices = matricesOf(unevenMembrane(spread));
            const StepFamily family{matrices.mass, matrices.damping, matrices.stiffness, factors};
            const double expected = exactLimit(family, 1e-9, 1e3);
            const double found =
                largestDefiniteStep(family, alternating(matrices.mass.rows()), {1e-8, 1e3, tolerance, {}});
            EXPECT_LE(found, (1 + 1e-9) * expected);
            EXPECT_GE(found, (1 - 2 * tolerance) * expected);
        }
}

TEST(LargestDefiniteStep, StopsAtTheCapAndAtWhatIsSure) {
    const Matrices matrices = matricesOf(unevenMembrane(1));
    const StepFamily family{matrices.mass, matrices.damping, matrices.stiffness, {4, 2, -1}};
    const Eigen::VectorXd near = alternating(matrices.mass.rows());
    const double limit = exactLimit(family, 1e-9, 1e3);
    EXPECT_EQ(largestDefiniteStep(family, near, {1e-8, limit / 2, tolerance, {}}), limit / 2);
    EXPECT_EQ(largestDefiniteStep(family, near, {limit, limit / 3, tolerance, {}}), limit / 3);
    EXPECT_EQ(largestDefiniteStep(family, near, {0.9999 * limit, 1e3, tolerance, {}}), 0.9999 * limit);
}

TEST(LargestDefiniteStep, HasNoLimitWhereNothingMakesItIndefinite) {
    const Matrices matrices = matricesOf(unevenMembrane(1));
    const StepFamily family{matrices.mass, matrices.damping, matrices.stiffness, {4, 2, 1}};
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(largestDefiniteStep(family, alternating(matrices.mass.rows()), {1e-3, infinite, tolerance, {}}),
              infinite);
}

TEST(LargestDefiniteStep, SeesTheOneSpringThatIsStifferAmongVeryMany) {
    SpringNetwork network;
    constexpr int nodes = 30000;
    for (int i = 0; i < nodes; ++i)
        network.restPositions.emplace_back(i, 0, 0);
    for (std::size_t i = 0; i + 1 < nodes; ++i)
        if (i != 20001) tissue::addSpring(network, i, i + 1);
    TissueModel model = tissue::model(std::move(network), {50, 0, 0.01});
    // Alone but for its two ends: ω² = 2c/m, where the chain's shortest wave has 4·50/m.
    for (const std::size_t end : {20000U, 20001U})
        model.springConstant[end] = 130;
    model.springConstant[19999] = model.springConstant[20002] = 1e-6;
    const Matrices matrices = matricesOf(model);
    const StepFamily family{matrices.mass, matrices.damping, matrices.stiffness, {4, -2, -1}};
    const double found = largestDefiniteStep(family, alternating(nodes), {1e-4, 1, tolerance, {}});
    EXPECT_NEAR(found, 2 / std::sqrt((2 * 130 + 65) * 1.0 / 0.01), 0.15 * found);
    EXPECT_LE(found, 2 / std::sqrt(2 * 130 / 0.01));
}

TEST(IsDampedBeyond, IsWhatTheLeastDampedMotionSays) {
    for (const double spread : {0.0, 1.0, 3.0}) {
        const Matrices matrices = matricesOf(unevenMembrane(spread));
        Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(dense(matrices.damping),
                                                                         dense(matrices.mass));
        const double least = solver.eigenvalues().minCoeff();
        for (const double h : {0.01, 3.0}) {
            EXPECT_TRUE(isDampedBeyond(0.99 * h * least, h, matrices.mass, matrices.damping)) << spread;
            EXPECT_FALSE(isDampedBeyond(1.01 * h * least, h, matrices.mass, matrices.damping)) << spread;
        }
    }
    TissueModel free = unevenMembrane(1);
    free.tethers.clear();
    const Matrices matrices = matricesOf(free);
    EXPECT_FALSE(isDampedBeyond(1e-6, 1, matrices.mass, matrices.damping));
}
