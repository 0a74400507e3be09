#include "core/model/net_elasticity.h"

#include "core/model/surface_net.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace esm {

namespace {

/// What answers to strains of the surface: to one in all directions, and to a stretch along the plane's first
/// direction and one between both, each with as much of the opposite across it. A stretch along direction φ
/// alone is the sum of 1, cos 2φ and sin 2φ of them.
using PerStrain = Eigen::RowVector3d;
/// How far a node goes in its plane, or the force on it.
using NodeResponse = Eigen::Matrix<double, 2, 3>;

/// The same for strains as another direction has them.
PerStrain turned(const PerStrain& response, const LineDirection& by) {
    return {response[0], by.real() * response[1] + by.imag() * response[2],
            by.real() * response[2] - by.imag() * response[1]};
}

/// Energy of springs over the direction φ in which the surface is stretched: mean + Re(twofold·e^{-2iφ} +
/// fourfold·e^{-4iφ}), with the area that it belongs to.
struct DirectedEnergy {
    double area = 0, mean = 0;
    std::complex<double> twofold = 0, fourfold = 0;
};

void add(DirectedEnergy& sum, const DirectedEnergy& part, double share, const LineDirection& turn) {
    sum.area += share * part.area;
    sum.mean += share * part.mean;
    sum.twofold += share * turn * part.twofold;
    sum.fourfold += share * turn * turn * part.fourfold;
}

/// How a net is pulled to measure it, and what is made of it.
struct VirtualPull {
    int sweeps;                     ///< of the nodes towards their balance
    double slowest;                 ///< swing that they follow fully; the fastest is 2
    int passes;                     ///< of the mean over a patch
    double mean, twofold, fourfold; ///< how much of an excess is taken away at once
};

// The stiffest spring decides how long a step may be. Wider bounds (0.02 to 50) made no mesh of the test data
// better; a net jittered by 0.4 of its spacing keeps to 6.
constexpr double smallestFactor = 0.05, largestFactor = 10;

// Van Gelder (1998): a spring is as stiff as the area that it stands for over its length squared. The scale
// is that of the regular net, whose springs have two triangles of √3/4·l².
std::vector<double> areaRule(const SurfaceNet& net) {
    std::vector<double> factors;
    for (const NetSpring& spring : net.springs) {
        const double factor = 2 / std::sqrt(3.0) * spring.area / (spring.length * spring.length);
        factors.push_back(factor < largestFactor ? std::max(factor, smallestFactor) : largestFactor);
    }
    return factors;
}

/// By how much each spring lengthens, in m per unit of each strain as the spring has it.
std::vector<PerStrain> elongations(const SurfaceNet& net, const std::vector<NodeResponse>& moved) {
    std::vector<PerStrain> result;
    result.reserve(net.springs.size());
    for (const NetSpring& spring : net.springs) {
        const auto [first, second] = spring.ends;
        result.push_back(spring.length / 2 * PerStrain(1, 1, 0) +
                         turned(second.along.transpose() * moved[second.node], second.direction) -
                         turned(first.along.transpose() * moved[first.node], first.direction));
    }
    return result;
}

std::vector<NodeResponse> forces(const SurfaceNet& net, const std::vector<double>& factors,
                                 const std::vector<PerStrain>& lengthened) {
    std::vector<NodeResponse> result(net.isInside.size(), NodeResponse::Zero());
    for (std::size_t i = 0; i < net.springs.size(); ++i) {
        const PerStrain pull = factors[i] * lengthened[i];
        const auto [first, second] = net.springs[i].ends;
        result[first.node] += first.along * turned(pull, std::conj(first.direction));
        result[second.node] -= second.along * turned(pull, std::conj(second.direction));
    }
    return result;
}

/// How far a node inside goes per force while its neighbours stay; none goes at a border, or where its
/// springs hold it in one direction only.
std::vector<Eigen::Matrix2d> compliances(const SurfaceNet& net, const std::vector<double>& factors) {
    std::vector<Eigen::Matrix2d> result(net.isInside.size(), Eigen::Matrix2d::Zero());
    for (std::size_t i = 0; i < net.springs.size(); ++i)
        for (const NetEnd& end : net.springs[i].ends)
            result[end.node] += factors[i] * end.along * end.along.transpose();
    for (std::size_t i = 0; i < result.size(); ++i) {
        const double trace = result[i].trace();
        const bool isFree = net.isInside[i] && result[i].determinant() > 1e-9 * trace * trace;
        result[i] = isFree ? Eigen::Matrix2d(result[i].inverse()) : Eigen::Matrix2d::Zero();
    }
    return result;
}

// Where the mesh is uneven, springs that are stretched evenly do not balance: their nodes shift, and a net
// gives way more than its springs tell. Chebyshev's iteration (Golub and Varga 1961) brings the nodes near to
// their balance with those around, a ring further with each sweep, and no further than asked for: every place
// is then still stretched as much as the others, and what it answers is its own. Of all steps scaled by
// `compliances` no swing is faster than 2: a spring's energy is at most twice that of its ends, each moved
// alone.
std::vector<PerStrain> balancedElongations(const SurfaceNet& net, const std::vector<double>& factors,
                                           const VirtualPull& pull) {
    const double middle = (2 + pull.slowest) / 2, half = (2 - pull.slowest) / 2;
    const std::vector<Eigen::Matrix2d> compliance = compliances(net, factors);
    std::vector<NodeResponse> moved(net.isInside.size(), NodeResponse::Zero()), step = moved;
    std::vector<PerStrain> lengthened = elongations(net, moved);
    double ratio = half / middle;
    for (int sweep = 0; sweep < pull.sweeps; ++sweep) {
        const double next = sweep == 0 ? 0 : 1 / (2 * middle / half - ratio);
        const double kept = next * ratio, taken = sweep == 0 ? 1 / middle : 2 * next / half;
        if (sweep > 0) ratio = next;
        const std::vector<NodeResponse> force = forces(net, factors, lengthened);
        for (std::size_t i = 0; i < moved.size(); ++i) {
            step[i] = kept * step[i] + taken * compliance[i] * force[i];
            moved[i] += step[i];
        }
        lengthened = elongations(net, moved);
    }
    return lengthened;
}

/// Of a spring, per unit of strain squared, its own direction being 0.
DirectedEnergy energyOf(double factor, const PerStrain& lengthened) {
    const std::complex<double> stretch(lengthened[1], lengthened[2]);
    return {0, factor / 2 * (lengthened[0] * lengthened[0] + std::norm(stretch) / 2),
            factor * lengthened[0] * stretch, factor / 4 * stretch * stretch};
}

// A spring's energy belongs to its triangles, by area, and a triangle's to its corners, as its area does. The
// triangles of a regular net are then even sheets each by itself, at a border too.
std::vector<DirectedEnergy> nodeEnergies(const SurfaceNet& net, const std::vector<double>& factors,
                                         const std::vector<PerStrain>& lengthened) {
    std::vector<DirectedEnergy> result(net.isInside.size());
    for (const NetTriangle& triangle : net.triangles) {
        DirectedEnergy whole{triangle.area};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t number = triangle.springs[i];
            if (number == noIndex || !(triangle.area > 0)) continue;
            add(whole, energyOf(factors[number], lengthened[number]),
                triangle.area / net.springs[number].area, triangle.directions[i]);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t number = triangle.springs[i];
            if (number == noIndex) continue;
            // Each edge hands on to both its ends, so that a corner takes of both edges at it.
            for (const NetEnd& end : net.springs[number].ends)
                add(result[end.node], whole, 1.0 / 6, end.direction * std::conj(triangle.directions[i]));
        }
    }
    return result;
}

/// Each pass is a mean with the neighbours: 16 make a patch of some hundred nodes, 40 one of 250.
std::vector<DirectedEnergy> patchEnergies(const SurfaceNet& net, std::vector<DirectedEnergy> energies,
                                          int passes) {
    std::vector<double> shares(energies.size(), 1);
    for (const NetSpring& spring : net.springs)
        for (const NetEnd& end : spring.ends)
            ++shares[end.node];
    for (double& share : shares)
        share = 1 / share;
    for (int pass = 0; pass < passes; ++pass) {
        std::vector<DirectedEnergy> next(energies.size());
        for (std::size_t i = 0; i < next.size(); ++i)
            add(next[i], energies[i], shares[i], 1);
        for (const NetSpring& spring : net.springs) {
            const auto [first, second] = spring.ends;
            const LineDirection turn = first.direction * std::conj(second.direction);
            add(next[first.node], energies[second.node], shares[first.node], turn);
            add(next[second.node], energies[first.node], shares[second.node], std::conj(turn));
        }
        energies = std::move(next);
    }
    return energies;
}

double excessAlong(const DirectedEnergy& energy, const LineDirection& direction, const VirtualPull& pull) {
    const double target = 3 * std::sqrt(3.0) / 8 * energy.area; // of the regular net: ½·E/(1 − ν²)
    if (!(target > 0)) return 0;
    const double twofold = (energy.twofold * std::conj(direction)).real();
    const double fourfold = (energy.fourfold * std::conj(direction * direction)).real();
    return (pull.mean * (energy.mean - target) + pull.twofold * twofold + pull.fourfold * fourfold) / target;
}

/// Makes springs softer or stiffer by what the patches around them show.
void correct(std::vector<double>& factors, const SurfaceNet& net, const VirtualPull& pull) {
    const std::vector<PerStrain> lengthened = balancedElongations(net, factors, pull);
    const auto patches = patchEnergies(net, nodeEnergies(net, factors, lengthened), pull.passes);
    for (std::size_t i = 0; i < factors.size(); ++i) {
        double excess = 0;
        for (const NetEnd& end : net.springs[i].ends)
            excess += excessAlong(patches[end.node], end.direction, pull) / 2;
        const double factor = factors[i] / std::clamp(1 + excess, 1.0 / 3, 3.0);
        factors[i] = std::clamp(factor, smallestFactor, largestFactor);
    }
}

// A spring in direction φ answers to stretches along ψ by cos⁴(φ − ψ), of which the mean is 3/8, the twofold
// part ½ and the fourfold one ⅛. Where springs run in all directions evenly, an excess that goes through
// their constants therefore shows as 1, 2/3 and 1/6 of itself. These are undone, the last by half only: it is
// small, and taken sixfold would be noise.
constexpr VirtualPull formPull{4, 0.25, 16, 1, 1.5, 3};
// Where few directions are to be had, the form stays uneven; the level need not. It is measured nearer to
// balance, over more nodes, as nodes of uneven nets shift together over some distance.
constexpr VirtualPull levelPull{10, 0.08, 40, 1, 0, 0};

/// Of the mean area that nodes have which have any.
constexpr double smallestArea = 0.3, largestArea = 300;

double sumOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Areas of nodes as shares whose mean is 1.
std::vector<double> overMean(std::vector<double> areas) {
    const auto without = static_cast<double>(std::count(areas.begin(), areas.end(), 0.0));
    const auto count = static_cast<double>(areas.size());
    const double mean = sumOf(areas) / (count - without);
    for (double& area : areas)
        area = area > 0 ? std::clamp(area / mean, smallestArea, largestArea) : 1;
    const double scale = count / sumOf(areas);
    for (double& area : areas)
        area *= scale;
    return areas;
}

} // namespace

// Three springs a node are too few to make every place of a mesh an even sheet, and single springs need not
// be one: what is felt is a patch. So the rule that is nearest to begin with is measured by a virtual pull,
// and springs are corrected by what patches show, first along their own direction, then all alike. The area
// rule is the one to begin with because it keeps Poisson's ratio at 1/3 where a mesh is uneven; equal
// constants, and a least-squares fit of balance and stiffness at each node, do not (docs/net-elasticity.md).
std::vector<double> netFactors(const std::vector<Eigen::Vector3d>& nodes, const std::vector<Spring>& springs,
                               const std::vector<Triangle>& triangles, const Progress& progress) {
    constexpr std::array pulls{formPull, formPull, formPull, formPull, levelPull};
    ProgressParts parts(progress);
    reportProgress(progress, 0);
    const SurfaceNet net = surfaceNet(nodes, springs, triangles);
    std::vector<double> factors = areaRule(net);
    for (const VirtualPull& pull : pulls) {
        correct(factors, net, pull);
        reportProgress(parts.next(1.0 / pulls.size()), 1);
    }
    std::vector<double> result(springs.size(), 1);
    for (std::size_t i = 0; i < factors.size(); ++i)
        result[net.springs[i].number] = factors[i];
    return result;
}

std::vector<double> nodeAreas(const std::vector<Eigen::Vector3d>& nodes,
                              const std::vector<Triangle>& triangles) {
    std::vector<double> areas(nodes.size(), 0);
    for (const Triangle& triangle : triangles)
        for (const std::uint32_t corner : triangle)
            areas[corner] += areaNormal(nodes, triangle).norm() / 6;
    return areas;
}

SheetShares sheetShares(const std::vector<Eigen::Vector3d>& nodes, const std::vector<Spring>& springs,
                        const std::vector<Triangle>& triangles, const Progress& progress) {
    return {netFactors(nodes, springs, triangles, progress), overMean(nodeAreas(nodes, triangles))};
}

} // namespace esm
