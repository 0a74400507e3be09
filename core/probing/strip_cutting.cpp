#include "core/probing/strip_cutting.h"

#include "core/geometry/disjoint_sets.h"
#include "core/probing/probed_spot.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace esm {

namespace {

using Eigen::Vector3d;

/// Distances of nodes: a strip of fewer shows the mesh rather than the tissue.
constexpr double leastWidth = 2, leastLength = 4;

bool isSolid(const ProbedOrgan& organ) {
    return organ.model.network->lattice.has_value();
}
/// Whether tissue lies beneath the surface, rather than a wall alone.
bool isDeep(const ProbedOrgan& organ) {
    return isSolid(organ) && !isWall(organ.model.network->lattice->filling);
}

/// Tetrahedra of what is filled, else the surface's triangles.
std::vector<TissueCell> cellsOf(const ProbedOrgan& organ) {
    std::vector<TissueCell> cells;
    if (isSolid(organ))
        for (const Tetrahedron& corners : organ.model.network->lattice->tetrahedra)
            cells.push_back({corners, 4});
    else
        for (const Triangle& corners : organ.surface.triangles)
            cells.push_back({{corners[0], corners[1], corners[2], 0}, 3});
    return cells;
}

/// m, of the cells' edges, a mean.
double edgeLength(const std::vector<TissueCell>& cells, const std::vector<Vector3d>& nodes) {
    double sum = 0;
    std::size_t count = 0;
    for (const TissueCell& cell : cells)
        for (std::size_t i = 1; i < cell.cornerCount; ++i)
            for (std::size_t j = 0; j < i; ++j, ++count)
                sum += (nodes[cell.corners[i]] - nodes[cell.corners[j]]).norm();
    return sum / static_cast<double>(count);
}

/// Of the organ's cells, whether each lies within the strip or is grasped by a clamp. A wall is followed
/// where it bends away, a solid no deeper than the strip is wide.
std::vector<char> cellsWithin(const std::vector<TissueCell>& cells, const std::vector<Vector3d>& nodes,
                              const StripFrame& frame, const StripSettings& settings, bool isDeep) {
    const double reach = settings.length / 2;
    std::vector<char> isWithin(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Vector3d middle = frame.coordinatesOf(middleOf(cells[i], nodes));
        const bool isBeside = std::abs(middle.y()) > settings.width / 2;
        const bool isBeneath = middle.z() < (isDeep ? -settings.width : -reach);
        const auto isBetween = [&](std::uint32_t node) {
            return std::abs(frame.coordinatesOf(nodes[node]).x()) < reach;
        };
        const auto corners = cells[i].nodes();
        const bool isAbove = middle.z() > reach;
        isWithin[i] =
            !isBeside && !isBeneath && !isAbove && std::any_of(corners.begin(), corners.end(), isBetween);
    }
    return isWithin;
}

/// Takes out what does not hang together with the cell nearest to the strip's middle.
void keepConnected(std::vector<char>& isWithin, const std::vector<TissueCell>& cells,
                   const std::vector<Vector3d>& nodes, const StripFrame& frame) {
    DisjointSets sets(nodes.size());
    std::optional<std::size_t> nearest;
    const auto distance = [&](std::size_t i) {
        return (middleOf(cells[i], nodes) - frame.place).squaredNorm();
    };
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!isWithin[i]) continue;
        for (const std::uint32_t node : cells[i].nodes())
            sets.join(cells[i].corners[0], node);
        if (!nearest || distance(i) < distance(*nearest)) nearest = i;
    }
    for (std::size_t i = 0; nearest && i < cells.size(); ++i)
        isWithin[i] =
            isWithin[i] && sets.lowest(cells[i].corners[0]) == sets.lowest(cells[*nearest].corners[0]);
}

// A spring stands for the tissue of all cells at it. Left whole at the cut, as many springs would hold less
// tissue, and the strip would be too firm the narrower it is; a border edge of the regular net, too, has half
// the constant of one within.
/// How much of an organ's tissue at its edges and nodes a strip has.
class Shares {
public:
    Shares(const std::vector<TissueCell>& cells, const std::vector<char>& isWithin,
           const std::vector<Vector3d>& nodes)
        : m_atNodes(nodes.size()) {
        std::vector<char> isOfStrip(nodes.size());
        for (std::size_t i = 0; i < cells.size(); ++i)
            for (const std::uint32_t node : cells[i].nodes())
                isOfStrip[node] |= isWithin[i];
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const auto corners = cells[i].nodes();
            if (std::none_of(corners.begin(), corners.end(), [&](auto node) { return isOfStrip[node]; }))
                continue;
            const double size = sizeOf(cells[i], nodes);
            for (const std::uint32_t node : cells[i].nodes()) {
                m_atNodes[node].add(size, isWithin[i]);
                for (const std::uint32_t other : cells[i].nodes())
                    if (node < other) m_atEdges[{node, other}].add(size, isWithin[i]);
            }
        }
    }

    double ofNode(std::uint32_t node) const { return m_atNodes[node].share(); }
    /// Of a spring that runs along no cell, that of its end with more: one that lies in the cut has only ends
    /// at the cut.
    double ofSpring(const Spring& spring) const {
        const auto edge = m_atEdges.find(std::minmax(spring.first, spring.second));
        if (edge != m_atEdges.end()) return edge->second.share();
        const double first = ofNode(spring.first), second = ofNode(spring.second);
        return std::min(first, second) > 0 ? std::max(first, second) : 0;
    }

private:
    struct Part {
        double whole = 0, within = 0; ///< m² or m³

        void add(double size, bool isWithin) {
            whole += size;
            if (isWithin) within += size;
        }
        double share() const { return whole > 0 ? within / whole : 0; }
    };
    std::vector<Part> m_atNodes;
    std::map<Edge, Part> m_atEdges;
};

/// The organ's tissue at a strip's cells alone, its nodes numbered anew.
class Cutting {
public:
    Cutting(const ProbedOrgan& organ, const std::vector<TissueCell>& cells, const std::vector<char>& isWithin)
        : m_organ(organ), m_shares(cells, isWithin, nodes()), m_number(nodes().size(), noIndex) {
        for (std::uint32_t node = 0; node < nodes().size(); ++node)
            if (m_shares.ofNode(node) > 0) {
                m_number[node] = static_cast<std::uint32_t>(m_kept.size());
                m_kept.push_back(node);
            }
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (isWithin[i]) m_cells.push_back(renumbered(cells[i]));
    }

    const std::vector<TissueCell>& cells() const { return m_cells; }

    TissueModel tissue() const {
        TissueModel cut;
        SpringNetwork network;
        for (const std::uint32_t node : m_kept) {
            network.restPositions.push_back(nodes()[node]);
            cut.mass.push_back(m_organ.model.mass[node]);
            cut.springConstant.push_back(m_organ.model.springConstant[node]);
            cut.viscosity.push_back(m_organ.model.viscosity[node]);
        }
        for (std::size_t i = 0; i < springs().size(); ++i) {
            const auto& [first, second, restLength] = springs()[i];
            const double share = m_shares.ofSpring(springs()[i]);
            if (share <= 0) continue;
            network.springs.push_back({m_number[first], m_number[second], restLength});
            const SpringValues whole = valuesOf(m_organ.model, i);
            cut.ownValues.push_back({share * whole.springConstant, share * whole.viscosity});
        }
        cut.network = std::make_shared<const SpringNetwork>(std::move(network));
        cut.stiffening = m_organ.model.stiffening;
        addHinges(cut);
        return cut;
    }

private:
    const std::vector<Vector3d>& nodes() const { return m_organ.model.network->restPositions; }
    const std::vector<Spring>& springs() const { return m_organ.model.network->springs; }
    TissueCell renumbered(TissueCell cell) const {
        for (std::size_t i = 0; i < cell.cornerCount; ++i)
            cell.corners[i] = m_number[cell.corners[i]];
        return cell;
    }

    /// Those both of whose triangles are the strip's.
    void addHinges(TissueModel& cut) const {
        std::set<Triangle> triangles;
        for (const TissueCell& cell : m_cells) {
            Triangle sorted{cell.corners[0], cell.corners[1], cell.corners[2]};
            std::sort(sorted.begin(), sorted.end());
            triangles.insert(sorted);
        }
        const auto isThere = [&](const Hinge& hinge, std::size_t corner) {
            Triangle sorted{hinge.nodes[0], hinge.nodes[1], hinge.nodes[corner]};
            std::sort(sorted.begin(), sorted.end());
            return triangles.count(sorted) > 0;
        };
        for (Hinge hinge : m_organ.model.hinges) {
            for (std::uint32_t& node : hinge.nodes)
                node = m_number[node];
            if (isThere(hinge, 2) && isThere(hinge, 3)) cut.hinges.push_back(hinge);
        }
    }

    const ProbedOrgan& m_organ;
    Shares m_shares;
    std::vector<std::uint32_t> m_number; ///< of each of the organ's nodes in the strip, or none
    std::vector<std::uint32_t> m_kept;   ///< the strip's nodes in the organ
    std::vector<TissueCell> m_cells;
};

/// A narrower strip would be a row of springs, a shorter one nothing but its clamps.
void requireFinerNodes(const StripSettings& settings, double spacing) {
    if (settings.width >= leastWidth * spacing && settings.length >= leastLength * spacing) return;
    throw InvalidModel("nodes lie " + millimetresText(spacing, 3) +
                       " apart there: a strip must be at least " + millimetresText(leastWidth * spacing, 3) +
                       " wide and " + millimetresText(leastLength * spacing, 3) + " long");
}

// The clamps hold whole nodes, as those of a laboratory do, rather than let the strip become narrower in
// them. That stiffens its ends, which the gauge does not see.
/// What lies beyond the strip's length on either side is grasped: a row of nodes, as far apart as the mesh
/// has them.
void clampEnds(CutStrip& strip, double length) {
    const std::vector<Vector3d>& nodes = strip.tissue.network->restPositions;
    for (std::uint32_t node = 0; node < nodes.size(); ++node) {
        const double x = strip.frame.coordinatesOf(nodes[node]).x();
        if (std::abs(x) < length / 2) continue;
        strip.clamped[x > 0 ? 1 : 0].push_back(node);
        strip.tissue.fixedNodes.push_back(node);
    }
    if (strip.clamped[0].empty() || strip.clamped[1].empty())
        throw InvalidModel("the organ ends before a strip of " + millimetresText(length, 3) +
                           " does there: choose a shorter one, another place or another direction");
    if (strip.tissue.fixedNodes.size() == nodes.size())
        throw InvalidModel("the strip has no node between its clamps: choose a longer one");
}

} // namespace

double sizeOf(const TissueCell& cell, const std::vector<Vector3d>& nodes) {
    if (cell.cornerCount == 4) return std::abs(volumeOf(cell.corners, nodes));
    return areaNormal(nodes, Triangle{cell.corners[0], cell.corners[1], cell.corners[2]}).norm() / 2;
}

Vector3d middleOf(const TissueCell& cell, const std::vector<Vector3d>& nodes) {
    Vector3d middle = Vector3d::Zero();
    for (const std::uint32_t node : cell.nodes())
        middle += nodes[node] / static_cast<double>(cell.cornerCount);
    return middle;
}

// Cells are taken or left whole. Were they cut in two, the strip would need springs that the organ has not,
// and slivers of cells make springs of any stiffness. The strip's sides are rough instead, by half a cell,
// and so is its width: the gauge measures that of the cells.
CutStrip cutStrip(const ProbedOrgan& organ, const StripSettings& settings) {
    const std::vector<Vector3d>& nodes = organ.model.network->restPositions;
    CutStrip strip;
    const std::vector<Triangle>& triangles = organ.surface.triangles;
    const RayHit hit = probedHit(organ, settings.place);
    strip.frame = stripFrame({nodes, triangles, {}}, spotAt(hit, triangles, nodes), settings);
    const std::vector<TissueCell> cells = cellsOf(organ);
    std::vector<char> isWithin = cellsWithin(cells, nodes, strip.frame, settings, isDeep(organ));
    keepConnected(isWithin, cells, nodes, strip.frame);
    const Cutting cutting(organ, cells, isWithin);
    strip.cells = cutting.cells();
    strip.tissue = cutting.tissue();
    requireFinerNodes(settings, strip.cells.empty()
                                    ? edgeLength(cells, nodes)
                                    : edgeLength(strip.cells, strip.tissue.network->restPositions));
    clampEnds(strip, settings.length);
    return strip;
}

} // namespace esm
