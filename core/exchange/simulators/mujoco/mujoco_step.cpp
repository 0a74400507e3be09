#include "core/exchange/simulators/mujoco/mujoco_step.h"

#include "core/dynamics/stability/stability.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double longestMujocoStep = 0.002; // s, which MuJoCo's models have unless they say otherwise
constexpr double stepMargin = 0.9, inertiaMargin = 1.1;

/// Sums without signs of the rows of the matrices of spring constants and viscosities, of springs and hinges.
struct RowSums {
    std::vector<double> elastic; ///< N/m, with tethers'
    std::vector<double> viscous; ///< N·s/m
};

RowSums rowSums(const SpringSystem& system) {
    RowSums sums{std::vector<double>(system.mass.size(), 0), std::vector<double>(system.mass.size(), 0)};
    const auto add = [&](std::uint32_t node, double share, double springConstant, double viscosity) {
        sums.elastic[node] += share * springConstant;
        sums.viscous[node] += share * viscosity;
    };
    for (const auto& spring : system.springs)
        for (const std::uint32_t node : {spring.first, spring.second})
            add(node, 2, largestSpringConstant(spring), spring.viscosity);
    for (const auto& hinge : system.hinges) {
        double total = 0;
        for (const double weight : hinge.weights)
            total += std::abs(weight);
        for (std::size_t i = 0; i < hinge.nodes.size(); ++i)
            add(hinge.nodes[i], total * std::abs(hinge.weights[i]), hinge.springConstant, hinge.viscosity);
    }
    for (const Tether& tether : system.tethers)
        add(tether.node, 1, tether.springConstant, 0);
    return sums;
}

/// s, up to which elasticity needs no more inertia than viscosity does.
double dampedStep(const RowSums& sums) {
    double step = noStepLimit;
    for (std::size_t node = 0; node < sums.elastic.size(); ++node)
        if (sums.elastic[node] > 0) step = std::min(step, 2 * sums.viscous[node] / sums.elastic[node]);
    return step;
}

/// No more than viscosity asks for, and as much again for springs: more would make the organ heavy.
std::vector<double> armatureFor(const MujocoJoints& joints, const RowSums& sums, double step) {
    const SpringSystem& system = joints.system;
    std::vector<double> armature(system.mass.size(), 0);
    for (std::size_t node = 0; node < armature.size(); ++node) {
        if (joints.still[node]) continue;
        const double viscous = step * sums.viscous[node] / 2, elastic = step * step * sums.elastic[node] / 4;
        const double needed = inertiaMargin * (viscous + std::min(elastic, viscous));
        armature[node] = std::max(0.0, needed - system.mass[node]);
    }
    return armature;
}

/// Viscosities between nodes that move and of what holds these; singular where nothing does.
Eigen::SparseMatrix<double> viscosityMatrix(const MujocoJoints& joints) {
    const auto& [system, still] = joints;
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&still = still, &entries](std::uint32_t node, std::uint32_t other, double value) {
        if (!still[node] && !still[other])
            entries.emplace_back(static_cast<int>(node), static_cast<int>(other), value);
    };
    for (const auto& [first, second, length, constant, viscosity, phase] : system.springs) {
        add(first, first, viscosity);
        add(second, second, viscosity);
        add(first, second, -viscosity);
        add(second, first, -viscosity);
    }
    for (const Tether& tether : system.tethers)
        add(tether.node, tether.node, tether.viscosity);
    for (std::uint32_t node = 0; node < system.mass.size(); ++node)
        if (still[node]) entries.emplace_back(static_cast<int>(node), static_cast<int>(node), 1.0);
    const auto size = static_cast<Eigen::Index>(system.mass.size());
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

/// s, the largest eigenvalue of D⁻¹·armature by power iteration, which finds it from below; infinite where
/// nothing holds some part by its viscosity. The slowest motion is smooth, and all move alike to begin with.
double lagOf(const MujocoJoints& joints, const std::vector<double>& armature) {
    const Eigen::VectorXd inertia =
        Eigen::Map<const Eigen::VectorXd>(armature.data(), static_cast<Eigen::Index>(armature.size()));
    if (inertia.isZero(0)) return 0;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(viscosityMatrix(joints));
    constexpr double rounding = 1e-12;
    if (factors.info() != Eigen::Success ||
        factors.vectorD().minCoeff() < rounding * factors.vectorD().maxCoeff())
        return noStepLimit;
    Eigen::VectorXd motion = Eigen::VectorXd::Ones(inertia.size());
    double lag = 0;
    constexpr int rounds = 30; // from a smooth start, enough for two digits
    for (int round = 0; round < rounds; ++round) {
        motion = factors.solve(inertia.cwiseProduct(motion)).eval();
        lag = motion.lpNorm<Eigen::Infinity>();
        motion /= lag;
    }
    return lag;
}

/// s, at which the lag comes to what it may be; it is in proportion to the step.
double unnoticedStep(const MujocoJoints& joints, const RowSums& sums) {
    const double longest = std::min(longestMujocoStep, stepMargin * dampedStep(sums));
    const double lag = lagOf(joints, armatureFor(joints, sums, longest));
    return lag > mostMujocoLag ? longest * mostMujocoLag / lag : longest;
}

/// Joints' own damping is as inertia that grows with the step.
bool isStableInMujoco(TissueModel tissue, const std::vector<double>& armature, double step) {
    for (std::size_t node = 0; node < armature.size(); ++node)
        tissue.mass[node] += armature[node];
    for (const Tether& tether : tissue.tethers)
        tissue.mass[tether.node] += step * tether.viscosity;
    return criticalStep(tissue, Integrator::Euler).value_or(0) >= step;
}

} // namespace

double largestMujocoStep(const TissueModel& tissue, const std::vector<double>& armature,
                         const Progress& progress) {
    constexpr double noneBelow = 1e-12, noneBeyond = 1e3; // s
    double stable = noneBelow, unstable = noneBeyond;
    if (isStableInMujoco(tissue, armature, unstable)) {
        reportProgress(progress, 1);
        return noStepLimit;
    }
    constexpr double tolerance = 1e-3;
    const double span = std::log(noneBeyond / noneBelow / tolerance);
    while (unstable > stable * (1 + tolerance)) {
        reportProgress(progress, 1 - std::log(unstable / stable / tolerance) / span);
        const double middle = std::sqrt(stable * unstable);
        (isStableInMujoco(tissue, armature, middle) ? stable : unstable) = middle;
    }
    reportProgress(progress, 1);
    return stable;
}

MujocoStep mujocoStep(const TissueModel& tissue, const MujocoJoints& joints, std::optional<double> timeStep,
                      const Progress& progress) {
    const std::vector<double> none(joints.still.size(), 0);
    const double plain = largestMujocoStep(tissue, none, progress);
    const RowSums sums = rowSums(joints.system);
    const auto usual = [&] {
        return std::max(std::min(stepMargin * plain, longestMujocoStep), unnoticedStep(joints, sums));
    };
    MujocoStep step{timeStep ? *timeStep : usual(), none, plain, 0};
    if (step.timeStep <= plain) return step;
    step.armature = armatureFor(joints, sums, step.timeStep);
    step.lag = lagOf(joints, step.armature);
    return step;
}

} // namespace esm
