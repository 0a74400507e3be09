#include "core/project/surroundings.h"

#include "core/geometry/disjoint_sets.h"
#include "core/model/net_elasticity.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// The part of the organ's size over which a poke fades.
constexpr double pokeExtent = 0.15;

double meanRestLength(const SpringNetwork& network) {
    double sum = 0;
    for (const Spring& spring : network.springs)
        sum += spring.restLength;
    return sum / static_cast<double>(network.springs.size());
}

/// A part held by fewer than three tethers could turn or drift away: a tether holds a place, one leaves all
/// turns free and two the turn about their line.
bool everyPartIsHeld(const SpringNetwork& network, std::uint32_t every) {
    const auto nodes = static_cast<std::uint32_t>(network.restPositions.size());
    DisjointSets parts(nodes);
    for (const Spring& spring : network.springs)
        parts.join(spring.first, spring.second);
    std::vector<std::uint32_t> tethers(nodes, 0);
    for (const Tether& tether : tethersOf({every, 1, 1}, outerNodes(network)))
        ++tethers[parts.lowest(tether.node)];
    for (std::uint32_t node = 0; node < nodes; ++node)
        if (tethers[parts.lowest(node)] < 3) return false;
    return true;
}

/// Of a wall the nodes of its outer side alone: what surrounds an organ does not reach into it.
std::vector<std::uint32_t> nodesToSurroundings(const SpringNetwork& network) {
    if (!isWall(network.lattice->filling)) return surfaceNodes(*network.lattice);
    std::vector<std::uint32_t> nodes = network.vertexNodes;
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

} // namespace

std::vector<OuterNode> outerNodes(const SpringNetwork& network) {
    std::vector<OuterNode> outer;
    if (!network.lattice) {
        for (std::uint32_t node = 0; node < network.restPositions.size(); ++node)
            outer.push_back({node, network.sheet ? network.sheet->nodes[node] : 1});
        return outer;
    }
    const std::vector<double> areas = nodeAreas(network.restPositions, network.lattice->surface);
    double area = 0;
    for (const std::uint32_t node : nodesToSurroundings(network)) {
        outer.push_back({node, areas[node]});
        area += areas[node];
    }
    for (OuterNode& node : outer)
        node.size *= static_cast<double>(outer.size()) / area;
    return outer;
}

std::vector<Tether> tethersOf(const TetherRule& rule, const std::vector<OuterNode>& outer) {
    std::vector<Tether> tethers;
    for (std::size_t i = 0; i < outer.size(); i += rule.every)
        tethers.push_back(
            {outer[i].node, outer[i].size * rule.springConstant, outer[i].size * rule.viscosity});
    return tethers;
}

std::size_t tetherCount(const TetherRule& rule, std::size_t outerNodes) {
    return (outerNodes + rule.every - 1) / rule.every;
}

std::size_t tetherCountOf(const SpringNetwork& network, const Scene& scene) {
    if (scene.tethers.empty()) return 0;
    const std::size_t outer = outerNodes(network).size();
    std::size_t count = 0;
    for (const TetherRule& rule : scene.tethers)
        count += tetherCount(rule, outer);
    return count;
}

TetherRule asStrong(TetherRule rule, std::size_t outerBefore, std::size_t outerAfter) {
    const double factor = static_cast<double>(tetherCount(rule, outerBefore)) /
                          static_cast<double>(tetherCount(rule, outerAfter));
    rule.springConstant *= factor;
    rule.viscosity *= factor;
    return rule;
}

// In a row of springs c with a tether k at each node, a displacement u at rest fulfils c·e²·u″ = k·u, e the
// springs' length: it fades as exp(−x/L) with L = e·sqrt(c/k). With L the given part of the organ's size, k/c
// is (e/L)². Of a regular net a node has the area √3/2·e²; taken from the area, all tethers together hold as
// strongly whatever the number of nodes.
double tetherShare(const SpringNetwork& network, const TriangleMesh& mesh) {
    const double extent = pokeExtent * boundingBox(mesh.vertices).diagonal().norm();
    const double area = surfaceArea(mesh);
    const double length = meanRestLength(network);
    const double perNode = 2 / std::sqrt(3.0) * area / static_cast<double>(network.restPositions.size());
    return (area > 0 ? perNode : length * length) / (extent * extent);
}

// The surrounding tissue [R 5.1], with the tissue's own relation of viscosity to stiffness, so that the organ
// on its tethers comes to rest as its tissue does. Every third node has one, as at the source, three times as
// strong as one at every node would be; small parts, which that would not hold, are a reason to tie all. An
// even sheet is tied everywhere: between every third node it would sag by how it is meshed.
TetherRule defaultTethers(const SpringNetwork& network, double share, double springConstant,
                          double viscosity) {
    const bool isEveryThird = !network.sheet && everyPartIsHeld(network, 3);
    const std::uint32_t every = isEveryThird ? 3 : 1;
    return {every, every * share * springConstant, every * share * viscosity};
}

} // namespace esm
