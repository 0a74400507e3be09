#include "core/solid/filled_body.h"

#include "core/solid/crossings.h"
#include "core/solid/lattice_springs.h"
#include "core/solid/prism_wall.h"
#include "core/solid/relaxation.h"
#include "core/solid/trimming.h"
#include "core/solid/unit_cell.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace esm {

namespace {

/// A ball's radius; of other bodies a measure of how thick they are, m: by volume over area, which needs no
/// directions and tells a plate from a ball of the same width.
double thickness(const ClosedBody& body) {
    return 3 * body.volume / body.area;
}

/// A body that is too small for the spacing still gets some three nodes across.
double spacingWithin(const ClosedBody& body, double spacing) {
    return std::min(spacing, thickness(body) / 1.5);
}

void checkFilling(const LatticeFilling& filling) {
    if (!isPositive(filling.spacing)) throw InvalidModel("the spacing of a lattice must be above 0 m");
}

const ClosedBody& largestOf(const std::vector<ClosedBody>& bodies) {
    return *std::max_element(bodies.begin(), bodies.end(),
                             [](const auto& one, const auto& other) { return one.volume < other.volume; });
}

std::string inMillimetres(double metres, int digits) {
    const double shown = 1000 * metres;
    return (shown < 100 ? roundedText(shown, digits) : roundedText(std::round(shown))) + " mm";
}

void refuseTooWide(const std::vector<ClosedBody>& bodies, double spacing) {
    const double thick = 2 * thickness(largestOf(bodies));
    if (spacing > thick)
        throw InvalidModel("a spacing of " + inMillimetres(spacing, 3) +
                           " is wider than the organ, which is about " + inMillimetres(thick, 3) +
                           " thick; choose " + inMillimetres(thick / 4, 2) + " or less");
}

// A thin body has a finer lattice than was asked for, and that one must not see the crossing.
std::vector<Crossing> crossingsAt(const std::vector<ClosedBody>& bodies, double spacing) {
    std::vector<double> spacings;
    spacings.reserve(bodies.size());
    for (const ClosedBody& body : bodies)
        spacings.push_back(spacingWithin(body, spacing));
    return crossingsOf(bodies, spacings);
}

const Crossing* widestOf(const std::vector<Crossing>& crossings) {
    const auto widest =
        std::max_element(crossings.begin(), crossings.end(), [](const Crossing& one, const Crossing& other) {
            return one.width / one.spacing < other.width / other.spacing;
        });
    return widest == crossings.end() ? nullptr : &*widest;
}

// Of a wide crossing no more is known than that it is: what is misplaced beyond it is not looked for. So each
// spacing that would do by what is known is tried.
/// The finest to two digits that sees no crossing, m; 0 where the organ is too thin for such a one.
double narrowingSpacing(const std::vector<ClosedBody>& bodies, double spacing, const Crossing& widest) {
    double least = 2 * widest.width;
    while (least > spacing && least <= 2 * thickness(largestOf(bodies))) {
        const double digit = std::pow(10, std::floor(std::log10(least)) - 1);
        spacing = digit * std::ceil(least / digit);
        const std::vector<Crossing> crossings = crossingsAt(bodies, spacing);
        const Crossing& left = *widestOf(crossings);
        if (left.isNarrow()) return spacing;
        least = 2 * left.width;
    }
    return 0;
}

void refuseWide(const std::vector<ClosedBody>& bodies, double spacing,
                const std::vector<Crossing>& crossings) {
    const Crossing& widest = *widestOf(crossings);
    if (widest.isNarrow()) return;
    std::size_t pairs = 0;
    for (const Crossing& crossing : crossings)
        pairs += crossing.pairs;
    const double enough = narrowingSpacing(bodies, spacing, widest);
    throw InvalidModel(
        "the surface runs through itself: " + std::to_string(pairs) +
        " pairs of triangles meet; the widest place, near " + placeText(widest.place) + ", is " +
        inMillimetres(widest.width, 2) + " across, and a lattice of " + inMillimetres(spacing, 3) +
        " passes over " + inMillimetres(widest.spacing / 2, 2) + " at most; " +
        (enough > 0 ? "choose a spacing of " + inMillimetres(enough, 2) + " or more, " : std::string()) +
        partOrJoinThem);
}

/// @throws InvalidModel for wide ones
NarrowCrossings narrowCrossings(const std::vector<ClosedBody>& bodies, double spacing) {
    const std::vector<Crossing> crossings = crossingsAt(bodies, spacing);
    if (crossings.empty()) return {};
    refuseWide(bodies, spacing, crossings);
    const auto widest =
        std::max_element(crossings.begin(), crossings.end(),
                         [](const auto& one, const auto& other) { return one.width < other.width; });
    return {crossings.size(), widest->width};
}

std::vector<ClosedBody> bodiesToFill(const TriangleMesh& mesh, const LatticeFilling& filling) {
    checkFilling(filling);
    std::vector<ClosedBody> bodies = closedBodiesOf(mesh);
    refuseTooWide(bodies, filling.spacing);
    return bodies;
}

void refuseTooMany(const LatticeEstimate& estimate, const LatticeFilling& filling) {
    if (!(estimate.nodes > mostLatticeNodes)) return;
    const double wider = filling.spacing * std::cbrt(1.1 * estimate.nodes / mostLatticeNodes);
    throw InvalidModel("a spacing of " + inMillimetres(filling.spacing, 3) + " needs about " +
                       roundedText(estimate.nodes / 1e6, 4) + " million nodes and " +
                       roundedText(std::ceil(estimate.bytes / 1e9)) + " GB of memory; " +
                       roundedText(mostLatticeNodes / 1e6, 2) +
                       " million nodes are the most, at a spacing of some " + inMillimetres(wider, 2));
}

/// Nodes that cuts add per spacing² of surface, beyond those that the volume has: measured on eight organs.
double surfaceNodesPerArea(LatticeKind kind) {
    return kind == LatticeKind::Cubic ? 0.6 : kind == LatticeKind::BodyCentred ? 0.88 : 0.5;
}

LatticeEstimate estimateOf(const std::vector<ClosedBody>& bodies, const LatticeFilling& filling) {
    const UnitCell& cell = unitCellOf(filling.kind);
    double within = 0, cuts = 0;
    for (const ClosedBody& body : bodies) {
        const double spacing = spacingWithin(body, filling.spacing);
        within += cell.density() * body.volume / std::pow(spacing, 3);
        cuts += surfaceNodesPerArea(filling.kind) * body.area / (spacing * spacing);
    }
    const auto sites = static_cast<double>(cell.sites.size());
    constexpr double springsPerCut = 3, moreTetrahedra = 1.04, bytesPerNode = 4000; // measured as well
    return {within + cuts, within * static_cast<double>(cell.springs.size()) / sites + springsPerCut * cuts,
            moreTetrahedra * within * static_cast<double>(cell.tetrahedra.size()) / sites,
            bytesPerNode * (within + cuts), spacingWithin(largestOf(bodies), filling.spacing)};
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
    BackgroundLattice background = uniformLattice(kind, spacing, body, query, parts.next(0.25));
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
Fitted fittedFinely(const ClosedBody& body, LatticeKind kind, double& spacing, const Progress& progress) {
    ProgressParts parts(progress);
    for (int tries = 0; tries < 4; ++tries) {
        refuseTooMany(estimateOf({body}, {kind, spacing}), {kind, spacing});
        Fitted result = fitted(body, kind, spacing, parts.nextOfRest(0.9));
        if (!result.lattice.tetrahedra.empty()) return result;
        spacing /= 2;
    }
    throw InvalidModel("a part of the surface is too thin to be filled; leave it out at import, or choose a "
                       "finer spacing than " +
                       inMillimetres(16 * spacing, 3));
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

// Nodes fall with the spacing, by its cube within and by its square at the surface: halving an interval of
// powers finds it.
LatticeFilling fillingOf(const TriangleMesh& mesh, LatticeKind kind, double nodes) {
    const std::vector<ClosedBody> bodies = closedBodiesOf(mesh);
    double finer = std::log(1e-3 * thickness(largestOf(bodies))),
           wider = std::log(thickness(largestOf(bodies)) / 1.5);
    for (int halving = 0; halving < 40; ++halving) {
        const double middle = (finer + wider) / 2;
        (estimateOf(bodies, {kind, std::exp(middle)}).nodes > nodes ? finer : wider) = middle;
    }
    const double spacing = std::exp(wider);
    const double digit = std::pow(10, std::floor(std::log10(spacing)) - 1);
    return {kind, digit * std::floor(spacing / digit)};
}

LatticeEstimate estimateLattice(const TriangleMesh& mesh, const LatticeFilling& filling) {
    if (isWall(filling)) return estimateWall(mesh, filling);
    const std::vector<ClosedBody> bodies = bodiesToFill(mesh, filling);
    LatticeEstimate estimate = estimateOf(bodies, filling);
    estimate.crossings = narrowCrossings(bodies, filling.spacing);
    return estimate;
}

NarrowCrossings narrowCrossings(const TriangleMesh& mesh, const LatticeFilling& filling) {
    if (isWall(filling)) return {};
    return narrowCrossings(bodiesToFill(mesh, filling), filling.spacing);
}

// A lattice over the body is cut to its surface, relaxed, and its springs set to rest where they are
// [R 3.3.1.3]. Each body by itself, so that springs never join tissue across a gap between two.
FilledBody fillBody(const TriangleMesh& mesh, const LatticeFilling& filling, const Progress& progress) {
    reportProgress(progress, 0);
    const std::vector<ClosedBody> bodies = bodiesToFill(mesh, filling);
    narrowCrossings(bodies, filling.spacing);
    const LatticeEstimate whole = estimateOf(bodies, filling);
    refuseTooMany(whole, filling);
    ProgressParts parts(progress);
    parts.next(0.05);
    FilledBody filled;
    filled.bodyStarts.push_back(0);
    for (const ClosedBody& body : bodies) {
        double spacing = spacingWithin(body, filling.spacing);
        const double share = estimateOf({body}, filling).nodes / whole.nodes;
        const Fitted lattice = fittedFinely(body, filling.kind, spacing, parts.next(0.9 * share));
        append(filled, lattice, spacing / filling.spacing);
        filled.enclosedVolume += body.volume;
    }
    reportProgress(parts.rest(), 1);
    return filled;
}

} // namespace esm
