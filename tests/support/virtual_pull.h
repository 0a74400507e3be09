#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/model/spring_network.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

/// Flat nets pulled until they balance: a linear solve that shares nothing with the program's own dynamics.
/// Everything is relative to the sheet that a regular net of constant 1 makes: modulus 2/√3, Poisson's ratio
/// 1/3.
namespace esm::test {

/// Nodes (x and y alone) and springs with their constants.
struct FlatNet {
    std::vector<Eigen::Vector2d> nodes;
    std::vector<Spring> springs;
    std::vector<double> constants;
};

inline FlatNet flatNet(const TriangleMesh& mesh, std::vector<double> constants) {
    FlatNet net{{}, networkFromMesh(mesh).springs, std::move(constants)};
    for (const Eigen::Vector3d& vertex : mesh.vertices)
        net.nodes.emplace_back(vertex.head<2>());
    return net;
}

/// Where each coordinate of a node is led to; those without are free.
using Led = std::vector<std::array<std::optional<double>, 2>>;

/// How far each node moves at small motion.
inline std::vector<Eigen::Vector2d> balanced(const FlatNet& net, const Led& led) {
    std::vector<Eigen::Index> row(2 * led.size(), -1);
    Eigen::Index rows = 0;
    for (std::size_t i = 0; i < row.size(); ++i)
        if (!led[i / 2][i % 2]) row[i] = rows++;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd force = Eigen::VectorXd::Zero(rows);
    for (std::size_t s = 0; s < net.springs.size(); ++s) {
        const std::size_t ends[2] = {net.springs[s].first, net.springs[s].second};
        const Eigen::Vector2d along = (net.nodes[ends[1]] - net.nodes[ends[0]]).normalized();
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = 0; b < 4; ++b) {
                const std::size_t i = 2 * ends[a / 2] + a % 2, j = 2 * ends[b / 2] + b % 2;
                const double stiffness = (a / 2 == b / 2 ? 1 : -1) * net.constants[s] *
                                         along[static_cast<int>(a % 2)] * along[static_cast<int>(b % 2)];
                if (row[i] < 0) continue;
                if (row[j] < 0)
                    force[row[i]] -= stiffness * *led[j / 2][j % 2];
                else
                    entries.emplace_back(row[i], row[j], stiffness);
            }
    }
    Eigen::SparseMatrix<double> matrix(rows, rows);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::VectorXd solved = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(force);
    std::vector<Eigen::Vector2d> moved(led.size());
    for (std::size_t i = 0; i < row.size(); ++i)
        moved[i / 2][static_cast<int>(i % 2)] = row[i] < 0 ? *led[i / 2][i % 2] : solved[row[i]];
    return moved;
}

/// A spring's energy, half of it at each of its ends.
inline std::vector<double> nodeEnergies(const FlatNet& net, const std::vector<Eigen::Vector2d>& moved) {
    std::vector<double> energies(net.nodes.size(), 0);
    for (std::size_t s = 0; s < net.springs.size(); ++s) {
        const auto [first, second, length] = net.springs[s];
        const Eigen::Vector2d along = (net.nodes[second] - net.nodes[first]).normalized();
        const double longer = along.dot(moved[second] - moved[first]);
        for (const std::uint32_t end : {first, second})
            energies[end] += net.constants[s] * longer * longer / 4;
    }
    return energies;
}

/// Energy per node of a net whose border is drawn with a uniform strain, everything within free.
inline std::vector<double> strainedEnergies(const FlatNet& net, const std::vector<bool>& isAtBorder,
                                            const Eigen::Matrix2d& strain) {
    Led led(net.nodes.size());
    for (std::size_t i = 0; i < led.size(); ++i)
        if (isAtBorder[i]) {
            const Eigen::Vector2d place = strain * net.nodes[i];
            led[i] = {place.x(), place.y()};
        }
    return nodeEnergies(net, balanced(net, led));
}

/// Of the sheet, per area.
inline double sheetEnergy(const Eigen::Matrix2d& strain) {
    return std::sqrt(3.0) / 8 * (strain.trace() * strain.trace() + 2 * strain.squaredNorm());
}

/// Young's modulus, over that of the sheet, of a strip pulled along x by clamps that let its ends become
/// narrower. Its ends are the nodes within `reach` of its box's.
inline double pulledModulus(const FlatNet& net, double area, double reach) {
    const auto [first, last] = std::minmax_element(
        net.nodes.begin(), net.nodes.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
    const double from = first->x() + reach, to = last->x() - reach;
    Led led(net.nodes.size());
    for (std::size_t i = 0; i < led.size(); ++i)
        if (net.nodes[i].x() < from || net.nodes[i].x() > to) led[i][0] = net.nodes[i].x();
    led[static_cast<std::size_t>(first - net.nodes.begin())][1] = 0;
    const std::vector<double> energies = nodeEnergies(net, balanced(net, led));
    return std::accumulate(energies.begin(), energies.end(), 0.0) / area * std::sqrt(3.0);
}

/// The `count` nodes nearest to one of them, itself first.
inline std::vector<std::size_t> patchAround(const FlatNet& net, std::size_t node, std::size_t count) {
    std::vector<std::size_t> order(net.nodes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto distance = [&](std::size_t i) { return (net.nodes[i] - net.nodes[node]).squaredNorm(); };
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                      [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    order.resize(count);
    return order;
}

/// The smallest and the largest of some numbers.
struct Extent {
    double least = std::numeric_limits<double>::infinity(), most = -least;

    void take(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
};

/// Energies over the sheet's, of a net whose border is drawn out by a uniform stretch in any of four
/// directions.
struct Judged {
    Extent whole;
    Extent patches; ///< of 100 nodes, around up to so many nodes as asked for, none reaching the border
};

/// @param areas per node, m²
inline Judged judged(const FlatNet& net, const std::vector<bool>& isAtBorder,
                     const std::vector<double>& areas, std::size_t patchCount) {
    std::vector<std::vector<std::size_t>> patches;
    const std::size_t stride = std::max<std::size_t>(1, net.nodes.size() / (2 * patchCount));
    for (std::size_t node = 0; node < net.nodes.size() && patches.size() < patchCount; node += stride) {
        patches.push_back(patchAround(net, node, 100));
        const auto reaches = [&](std::size_t i) { return isAtBorder[i]; };
        if (std::any_of(patches.back().begin(), patches.back().end(), reaches)) patches.pop_back();
    }
    Judged result;
    for (int direction = 0; direction < 4; ++direction) {
        const Eigen::Vector2d along(std::cos(M_PI * direction / 4), std::sin(M_PI * direction / 4));
        const Eigen::Matrix2d strain = along * along.transpose();
        const std::vector<double> energies = strainedEnergies(net, isAtBorder, strain);
        const auto ratio = [&](const auto& nodes) {
            double energy = 0, area = 0;
            for (const std::size_t i : nodes) {
                energy += energies[i];
                area += areas[i];
            }
            return energy / area / sheetEnergy(strain);
        };
        std::vector<std::size_t> all(net.nodes.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        result.whole.take(ratio(all));
        for (const std::vector<std::size_t>& patch : patches)
            result.patches.take(ratio(patch));
    }
    return result;
}

} // namespace esm::test
