#include "core/solid/filled_body.h"

#include "core/solid/graded_lattice.h"
#include "core/solid/lattice_springs.h"
#include "core/solid/prism_wall.h"
#include "core/solid/relaxation.h"
#include "core/solid/trimming.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace esm {

namespace {

void checkFilling(const LatticeFilling& filling) {
    if (!isPositive(filling.spacing)) throw InvalidModel("the spacing of a lattice must be above 0 m");
}

void refuseTooWide(const std::vector<ClosedBody>& bodies, double spacing) {
    const double thick = 2 * thickness(largestOf(bodies));
    if (spacing > thick)
        throw InvalidModel("a spacing of " + millimetresText(spacing, 3) +
                           " is wider than the organ, which is about " + millimetresText(thick, 3) +
                           " thick; choose " + millimetresText(thick / 4, 2) + " or less");
}

std::vector<ClosedBody> bodiesToFill(const TriangleMesh& mesh, const LatticeFilling& filling) {
    checkFilling(filling);
    std::vector<ClosedBody> bodies = closedBodiesOf(mesh);
    refuseTooWide(bodies, filling.spacing);
    return bodies;
}

using EstimateOf = std::function<LatticeEstimate(double spacing)>;

// Nodes fall with the spacing, by its cube within, or less where cubes are wider there, and by its square at
// the surface: halving an interval of powers finds it.
/// The spacing between two, m, with which a lattice has so many nodes.
double spacingWith(const EstimateOf& estimate, double nodes, double finer, double wider) {
    for (int halving = 0; halving < 40; ++halving) {
        const double middle = std::sqrt(finer * wider);
        (estimate(middle).nodes > nodes ? finer : wider) = middle;
    }
    return wider;
}

void refuseTooMany(const EstimateOf& estimate, double spacing) {
    const LatticeEstimate now = estimate(spacing);
    if (!(now.nodes > mostLatticeNodes)) return;
    const double widest = spacing * std::sqrt(now.nodes / mostLatticeNodes);
    const double enough =
        toTwoDigitsUp(spacingWith(estimate, 0.95 * mostLatticeNodes, spacing, 1.1 * widest));
    throw InvalidModel("a spacing of " + millimetresText(spacing, 3) + " needs about " +
                       roundedText(now.nodes / 1e6, 4) + " million nodes and " +
                       roundedText(std::ceil(now.bytes / 1e9)) + " GB of memory; " +
                       roundedText(mostLatticeNodes / 1e6, 2) +
                       " million nodes are the most, at a spacing of some " + millimetresText(enough, 2));
}

/// A lattice in one body.
struct Fitted {
    StuffedLattice lattice;
    std::vector<FittedSpring> springs;
};

std::vector<char> movedNodes(const std::vector<Eigen::Vector3d>& before,
                             const std::vector<Eigen::Vector3d>& after) {
    std::vector<char> isMoved(before.size());
    for (std::size_t i = 0; i < before.size(); ++i)
        isMoved[i] = before[i] != after[i] ? 1 : 0;
    return isMoved;
}

/// Whether springs run through tetrahedra, and not along their edges alone.
bool hasSpringsAcross(LatticeKind kind) {
    return kind == LatticeKind::Cubic || kind == LatticeKind::Diamond;
}

/// Springs that are no edges of tetrahedra may leave where none of these does.
void dropLeavingSprings(Fitted& fitted, const BodyQuery& query, double deepest) {
    const auto leaves = [&](const FittedSpring& spring) {
        auto [first, second, constant] = spring.spring;
        const StuffedLattice& lattice = fitted.lattice;
        if (lattice.isOnSurface[first]) std::swap(first, second);
        return leavesBody(query, {lattice.nodes[first], lattice.nodes[second], !lattice.isOnSurface[first]},
                          deepest);
    };
    fitted.springs.erase(std::remove_if(fitted.springs.begin(), fitted.springs.end(), leaves),
                         fitted.springs.end());
}

// The springs that relax are those of the cut lattice; afterwards each is as stiff as its tetrahedra have
// become.
Fitted fitted(const ClosedBody& body, LatticeKind kind, double spacing, const Progress& progress) {
    ProgressParts parts(progress);
    const BodyQuery query(body);
    const double deepest = deepestChord(kind, spacing);
    const Progress lays = parts.next(0.25);
    BackgroundLattice background = kind == LatticeKind::Graded
                                       ? gradedLattice(spacing, body, query, lays)
                                       : uniformLattice(kind, spacing, body, query, lays);
    Fitted result;
    StuffedLattice& lattice = result.lattice = stuffed(background, query, parts.next(0.1));
    trim(lattice, std::vector<char>(lattice.nodes.size(), 1), query, deepest, parts.next(0.15));
    const std::vector<Eigen::Vector3d> before = lattice.nodes;
    relax(lattice, fittedSprings(background, lattice), query, spacing, parts.next(0.3));
    trim(lattice, movedNodes(before, lattice.nodes), query, deepest, parts.next(0.15));
    result.springs = fittedSprings(background, lattice);
    if (hasSpringsAcross(kind)) dropLeavingSprings(result, query, deepest);
    reportProgress(parts.rest(), 1);
    return result;
}

/// Finer until something of the body is filled: a thin one may lie between the nodes of the first try.
/// @throws InvalidModel where that would need too many nodes
Fitted fittedFinely(const ClosedBody& body, LatticeKind kind, double& spacing, const EstimateOf& estimate,
                    const Progress& progress) {
    ProgressParts parts(progress);
    for (int tries = 0; tries < 4; ++tries) {
        refuseTooMany(estimate, spacing);
        Fitted result = fitted(body, kind, spacing, parts.nextOfRest(0.9));
        if (!result.lattice.tetrahedra.empty()) return result;
        spacing /= 2;
    }
    throw InvalidModel("a part of the surface is too thin to be filled; leave it out at import, or choose a "
                       "finer spacing than " +
                       millimetresText(16 * spacing, 3));
}

/// @param stiffness what a finer lattice's constants are multiplied by, for the same modulus
void append(FilledBody& filled, const Fitted& fitted, double stiffness) {
    const auto first = static_cast<std::uint32_t>(filled.nodes.size());
    const StuffedLattice& lattice = fitted.lattice;
    filled.nodes.insert(filled.nodes.end(), lattice.nodes.begin(), lattice.nodes.end());
    filled.isOnSurface.insert(filled.isOnSurface.end(), lattice.isOnSurface.begin(),
                              lattice.isOnSurface.end());
    for (const auto& [spring, latticeLength] : fitted.springs)
        filled.springs.push_back({spring.first + first, spring.second + first, stiffness * spring.constant});
    for (Tetrahedron nodes : lattice.tetrahedra) {
        for (std::uint32_t& node : nodes)
            node += first;
        filled.tetrahedra.push_back(nodes);
    }
    filled.bodyStarts.push_back(static_cast<std::uint32_t>(filled.nodes.size()));
}

} // namespace

LatticeFilling fillingOf(const TriangleMesh& mesh, LatticeKind kind, double nodes) {
    const std::vector<ClosedBody> bodies = closedBodiesOf(mesh);
    const LatticeEstimator estimator(bodies, kind);
    const double thick = thickness(largestOf(bodies));
    const double spacing = spacingWith([&](double tried) { return estimator.estimate(tried); }, nodes,
                                       1e-3 * thick, thick / 1.5);
    const double digit = std::pow(10, std::floor(std::log10(spacing)) - 1);
    return {kind, digit * std::floor(spacing / digit)};
}

LatticeEstimate estimateLattice(const TriangleMesh& mesh, const LatticeFilling& filling,
                                const Progress& progress) {
    if (isWall(filling)) return estimateWall(mesh, filling);
    const std::vector<ClosedBody> bodies = bodiesToFill(mesh, filling);
    LatticeEstimate estimate = LatticeEstimator(bodies, filling.kind).estimate(filling.spacing);
    estimate.crossings = narrowCrossingsOf(bodies, filling.spacing, progress);
    return estimate;
}

NarrowCrossings narrowCrossings(const TriangleMesh& mesh, const LatticeFilling& filling,
                                const Progress& progress) {
    if (isWall(filling)) return {};
    return narrowCrossingsOf(bodiesToFill(mesh, filling), filling.spacing, progress);
}

// A lattice over the body is cut to its surface, relaxed, and its springs set to rest where they are
// [R 3.3.1.3]. Each body by itself, so that springs never join tissue across a gap between two.
FilledBody fillBody(const TriangleMesh& mesh, const LatticeFilling& filling, const Progress& progress) {
    reportProgress(progress, 0);
    const std::vector<ClosedBody> bodies = bodiesToFill(mesh, filling);
    const LatticeEstimator estimator(bodies, filling.kind);
    refuseTooMany([&](double spacing) { return estimator.estimate(spacing); }, filling.spacing);
    const double nodes = estimator.estimate(filling.spacing).nodes;
    ProgressParts parts(progress);
    narrowCrossingsOf(bodies, filling.spacing, parts.next(0.1));
    FilledBody filled;
    filled.bodyStarts.push_back(0);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const auto estimate = [&](double spacing) { return estimator.estimateIn(i, spacing); };
        double spacing = spacingWithin(bodies[i], filling.spacing);
        const double share = estimate(spacing).nodes / nodes;
        const Fitted lattice =
            fittedFinely(bodies[i], filling.kind, spacing, estimate, parts.next(0.85 * share));
        append(filled, lattice, spacing / filling.spacing);
        filled.enclosedVolume += bodies[i].volume;
    }
    reportProgress(parts.rest(), 1);
    return filled;
}

} // namespace esm
