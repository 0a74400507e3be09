#include "core/dynamics/spectrum/fluid_stiffness.h"

#include "core/dynamics/block_entries.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// How much larger the wall's area may be than at rest: under a pressure that its fluid resists, as much as
/// that lets the volume grow, and a quarter more for what bends and presses it. Where nothing but the wall
/// resists, four times: a ball of linear springs bursts at twice its width.
double areaGrowth(const SpringSystem::Filled& cavity) {
    constexpr double bent = 1.25, burst = 4;
    if (cavity.stiffness == 0) return burst;
    return std::min(burst, bent * std::cbrt(std::pow(1 + cavity.largestPressure / cavity.stiffness, 2)));
}

Matrix3d crossMatrix(const Vector3d& d) {
    Matrix3d matrix;
    matrix << 0, -d.z(), d.y(), d.z(), 0, -d.x(), -d.y(), d.x(), 0;
    return matrix;
}

// Of a ring's side (a, b) the gradient at x has (a − x)×(b − x)/6. Over a closed ring that is Σ a×b/6, of
// which the parts by a and b are −[b]×/6 and [a]×/6; places are taken from x, since the ring's sum does not
// depend on where they are taken from.
void addTurning(BlockEntries& entries, const SpringSystem::Filled& cavity, double pressure,
                const Vectors& places) {
    const CavityWall& wall = *cavity.wall;
    for (std::uint32_t place = 0; place < wall.size(); ++place)
        for (std::uint32_t i = wall.starts[place]; i < wall.starts[place + 1]; ++i) {
            const auto [from, to] = wall.sides[i];
            const Vector3d a = places[from] - places.front(), b = places[to] - places.front();
            entries.add(wall.nodes[place], wall.nodes[from], pressure / 6 * crossMatrix(b));
            entries.add(wall.nodes[place], wall.nodes[to], -pressure / 6 * crossMatrix(a));
        }
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
            addTurning(entries, cavity, std::sqrt(growth) * cavity.largestPressure, places);
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
