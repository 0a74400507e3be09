#include "core/dynamics/spectrum/fluid_stiffness.h"

#include "core/dynamics/fluid_entries.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

namespace {

/// How much larger the wall's area may be than at rest: under a pressure that its fluid resists, as much as
/// that lets the volume grow, and a quarter more for what bends and presses it. Where nothing but the wall
/// resists, four times: a ball of linear springs bursts at twice its width.
double areaGrowth(const SpringSystem::Filled& cavity) {
    constexpr double bent = 1.25, burst = 4;
    if (cavity.stiffness == 0) return burst;
    return std::min(burst, bent * std::cbrt(std::pow(1 + cavity.largestPressure / cavity.stiffness, 2)));
}

Eigen::VectorXd column(const SpringSystem::Filled& cavity, const Vectors& gradient,
                       const BlockEntries& entries) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(entries.rowCount());
    for (std::size_t place = 0; place < gradient.size(); ++place)
        if (const int row = entries.rowOf(cavity.wall->nodes[place]); row >= 0)
            result.segment<3>(row) = std::sqrt(pressureSlope(cavity)) * gradient[place];
    return result;
}

} // namespace

SymmetricSum fluidStiffness(const SpringSystem& system, Deformation deformation) {
    BlockEntries entries(system.fixed);
    Eigen::MatrixXd columns(entries.rowCount(), 0);
    for (const SpringSystem::Filled& cavity : system.cavities) {
        const Vectors places = placesOf(*cavity.wall, system.network->restPositions);
        const double growth = deformation == Deformation::Any ? areaGrowth(cavity) : 1;
        if (cavity.largestPressure > 0)
            addTurning(cavity, std::sqrt(growth) * cavity.largestPressure, places, entries);
        if (cavity.stiffness == 0) continue;
        columns.conservativeResize(Eigen::NoChange, columns.cols() + 1);
        columns.col(columns.cols() - 1) =
            growth * column(cavity, volumeOf(*cavity.wall, places).gradient, entries);
    }
    return {entries.matrix(), std::move(columns)};
}

Eigen::SparseMatrix<double> forThreeAxes(const Eigen::SparseMatrix<double>& lower) {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(3 * static_cast<std::size_t>(lower.nonZeros()));
    for (int column = 0; column < lower.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator it(lower, column); it; ++it)
            for (int axis = 0; axis < 3; ++axis)
                entries.emplace_back(3 * static_cast<int>(it.row()) + axis, 3 * column + axis, it.value());
    Eigen::SparseMatrix<double> result(3 * lower.rows(), 3 * lower.cols());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

} // namespace esm
