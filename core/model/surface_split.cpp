#include "core/model/surface_split.h"

#include "core/geometry/edge_path.h"
#include "core/support/errors.h"

#include <algorithm>

#include <set>

namespace esm {

namespace {

/// m²
double areaOf(const Triangle& t, const std::vector<Eigen::Vector3d>& at) {
    return (at[t[1]] - at[t[0]]).cross(at[t[2]] - at[t[0]]).norm() / 2;
}

// The tissue is parted where its triangles meet, along their edges; no triangle is cut. Round each node that
// becomes two, the triangles on the right of the path go with the twin, and with them every spring to a node
// that was met there. Sides are told by the triangles alone (edge_path.cpp), so that they hold on the
// thinnest tissue too.
//
// No node is moved and nothing is added. Mass is shared by area, spring constants along the path in halves:
// what was one node or spring is two that do together what the one did. Mass, momentum and energy therefore
// stay what they are. The source takes a new node's mass from all nodes around it [R 4.14]. That keeps the
// sum as well, but changes the momentum of nodes that the cut does not meet.
//
// The whole organ is copied once: time goes with its size, and not with the length of the path.
class SurfaceSplitter {
public:
    SurfaceSplitter(const Topology& topology, const TissueModel& tissue, const EdgePath& path)
        : m_before(topology), m_tissue(tissue), m_network(*topology.network),
          m_path(verticesAlong(path, m_network.restPositions.size())) {
        if (m_network.lattice) throw InvalidModel("an organ that is filled cannot be split; make it hollow");
        if (m_network.binding)
            throw InvalidModel(
                "fewer nodes carry the surface, so that it has no edges to part along; simulate all");
        const std::vector<Triangle>& drawn = topology.surface->triangles;
        for (std::uint32_t i = 0; i < drawn.size(); ++i) {
            const Triangle nodes{m_network.vertexNodes[drawn[i][0]], m_network.vertexNodes[drawn[i][1]],
                                 m_network.vertexNodes[drawn[i][2]]};
            if (nodes[0] == nodes[1] || nodes[1] == nodes[2] || nodes[2] == nodes[0]) continue;
            m_triangles.push_back(nodes);
            m_drawn.push_back(i);
        }
    }

    SplitTissue split() {
        const TriangleSides sides(m_triangles);
        findParted(sides);
        SplitTissue result{{}, m_tissue, NodeMap::identity(m_network.restPositions.size()), m_parted};
        for (const PartedNode& parted : m_parted)
            result.map.add({{parted.node, 1}});
        result.topology.origin = m_before.origin;
        auto network = std::make_shared<SpringNetwork>(m_network);
        partNodes(result, *network);
        partSprings(sides, result.tissue, *network);
        partHinges(result.tissue);
        result.topology.surface = partedSurface(*network);
        result.topology.network = result.tissue.network = std::move(network);
        return result;
    }

private:
    /// What goes with a parted node's twin.
    struct Side {
        std::uint32_t twin;
        double share; ///< 0 to 1, of the area
        RightSide right;
    };

    /// An edge of the border is refused before anything is parted: there is nothing on its other side to part
    /// from. An end inside the surface has no sides and stays one node.
    void findParted(const TriangleSides& sides) {
        std::vector<double> areas(m_network.restPositions.size());
        for (const Triangle& triangle : m_triangles)
            for (const std::uint32_t node : triangle)
                areas[node] += areaOf(triangle, m_network.restPositions);
        const std::vector<std::uint32_t>& nodes = m_path.vertices;
        for (std::size_t place = 0; place < nodes.size(); ++place)
            if (const auto next = m_path.after(place)) sides.requireInner(nodes[place], *next);
        for (std::size_t place = 0; place < nodes.size(); ++place)
            if (auto right = rightSideOf(sides, m_path, place))
                part(nodes[place], std::move(*right), areas[nodes[place]]);
        if (m_parted.empty())
            throw InvalidModel(
                "an edge inside the surface parts nothing by itself: name two in a row, or one "
                "from the border");
    }

    /// Shared by the area at rest, over which even tissue has its mass spread. @param area m², of all
    /// triangles at the node
    void part(std::uint32_t node, RightSide right, double area) {
        double ofRight = 0;
        for (const std::uint32_t triangle : right.triangles)
            ofRight += areaOf(m_triangles[triangle], m_network.restPositions);
        const double share = ofRight / area;
        if (!(share > 0 && share < 1))
            throw InvalidModel("the triangles on one side of node " + std::to_string(node) +
                               " have no area to share its mass by");
        const auto twin = static_cast<std::uint32_t>(m_network.restPositions.size() + m_parted.size());
        m_parted.push_back({node, twin, share});
        m_sides.emplace(node, Side{twin, share, std::move(right)});
    }

    /// What the twin gets is taken from the node, and not computed a second time: sums then stay the same to
    /// rounding. Both have their place and, as the motion is mapped, their velocity in common.
    void partNodes(SplitTissue& result, SpringNetwork& network) const {
        TissueModel& tissue = result.tissue;
        for (const auto& [node, twin, share] : m_parted) {
            network.restPositions.push_back(m_network.restPositions[node]);
            result.topology.origin.push_back(m_before.origin[node]);
            tissue.springConstant.push_back(m_tissue.springConstant[node]);
            tissue.viscosity.push_back(m_tissue.viscosity[node]);
            tissue.mass.push_back(share * m_tissue.mass[node]);
            tissue.mass[node] -= tissue.mass.back();
            if (network.sheet) partShare(network.sheet->nodes, node, share);
            if (std::binary_search(m_tissue.fixedNodes.begin(), m_tissue.fixedNodes.end(), node))
                tissue.fixedNodes.push_back(twin);
        }
        for (std::size_t i = 0; i < m_tissue.tethers.size(); ++i) {
            const auto& [node, springConstant, viscosity] = m_tissue.tethers[i];
            const auto parted = m_sides.find(node);
            if (parted == m_sides.end()) continue;
            const auto& [twin, share, right] = parted->second;
            tissue.tethers.push_back({twin, share * springConstant, share * viscosity});
            tissue.tethers[i] = {node, (1 - share) * springConstant, (1 - share) * viscosity};
        }
    }

    static void partShare(std::vector<double>& nodes, std::uint32_t node, double share) {
        nodes.push_back(share * nodes[node]);
        nodes[node] -= nodes.back();
    }

    std::uint32_t rightOf(std::uint32_t node) const {
        const auto parted = m_sides.find(node);
        return parted == m_sides.end() ? node : parted->second.twin;
    }

    /// Where the end of a spring from a node to another one lies.
    std::uint32_t endOf(std::uint32_t node, std::uint32_t other) const {
        const auto parted = m_sides.find(node);
        const bool isRight = parted != m_sides.end() && parted->second.right.neighbours.count(other) > 0;
        return isRight ? parted->second.twin : node;
    }

    /// A spring within the body, as a lattice has, belongs to no triangle that would tell its side. A wrong
    /// guess would hold both sides together.
    void requireSide(const Spring& spring, const TriangleSides& sides) const {
        const bool isParted = m_sides.count(spring.first) + m_sides.count(spring.second) > 0;
        if (isParted && !sides.hasEdge(spring.first, spring.second))
            throw InvalidModel("the spring from node " + std::to_string(spring.first) + " to node " +
                               std::to_string(spring.second) +
                               " is no edge of the surface: on which side it goes is not known");
    }

    /// A spring along the path has half its ends' mean, so that all springs get values of their own. Nodes
    /// keep what regions say of them.
    void partSprings(const TriangleSides& sides, TissueModel& tissue, SpringNetwork& network) const {
        tissue.ownValues = springValues(m_tissue);
        for (std::size_t i = 0; i < m_network.springs.size(); ++i) {
            const Spring& spring = m_network.springs[i];
            requireSide(spring, sides);
            if (!m_path.runsAlong(spring.first, spring.second)) {
                network.springs[i] = {endOf(spring.first, spring.second), endOf(spring.second, spring.first),
                                      spring.restLength};
                continue;
            }
            SpringValues& values = tissue.ownValues[i];
            values = {values.springConstant / 2, values.viscosity / 2};
            const SpringValues half = values;
            tissue.ownValues.push_back(half);
            if (network.sheet) halveShare(network.sheet->springs, i);
            network.springs.push_back({rightOf(spring.first), rightOf(spring.second), spring.restLength});
        }
    }

    static void halveShare(std::vector<double>& springs, std::size_t spring) {
        springs[spring] /= 2;
        springs.push_back(double(springs[spring]));
    }

    /// Whether the triangles along an edge that is not parted go with a node's twin.
    bool goesRight(std::uint32_t node, std::uint32_t first, std::uint32_t second) const {
        const auto parted = m_sides.find(node);
        if (parted == m_sides.end()) return false;
        const std::vector<std::uint32_t>& right = parted->second.right.triangles;
        return std::any_of(right.begin(), right.end(), [&](std::uint32_t triangle) {
            const Triangle& nodes = m_triangles[triangle];
            const auto has = [&](std::uint32_t wanted) {
                return std::find(nodes.begin(), nodes.end(), wanted) != nodes.end();
            };
            return has(first) && has(second);
        });
    }

    /// A hinge along the path has no two triangles any more. Every other one keeps both, and goes with them.
    void partHinges(TissueModel& tissue) const {
        tissue.hinges.clear();
        for (Hinge hinge : m_tissue.hinges) {
            const std::uint32_t first = hinge.nodes[0], second = hinge.nodes[1];
            if (m_path.runsAlong(first, second)) continue;
            for (std::uint32_t& node : hinge.nodes)
                if (goesRight(node, first, second)) node = rightOf(node);
            tissue.hinges.push_back(hinge);
        }
    }

    /// Each vertex that is drawn at a parted node becomes two where triangles of both sides meet at it.
    /// Several vertices may hang on one node; each gets a twin of its own.
    std::shared_ptr<const TriangleMesh> partedSurface(SpringNetwork& network) const {
        auto mesh = std::make_shared<TriangleMesh>(*m_before.surface);
        for (const PartedNode& parted : m_parted) {
            std::map<std::uint32_t, std::uint32_t> twins; ///< of drawn vertices
            for (const std::uint32_t triangle : m_sides.at(parted.node).right.triangles)
                for (std::uint32_t& vertex : mesh->triangles[m_drawn[triangle]]) {
                    if (network.vertexNodes[vertex] != parted.node) continue;
                    const auto next = static_cast<std::uint32_t>(mesh->vertices.size());
                    const auto [twin, isNew] = twins.emplace(vertex, next);
                    if (isNew) {
                        mesh->vertices.push_back(Eigen::Vector3d(mesh->vertices[vertex]));
                        network.vertexNodes.push_back(parted.twin);
                    }
                    vertex = twin->second;
                }
        }
        return mesh;
    }

    const Topology& m_before;
    const TissueModel& m_tissue;
    const SpringNetwork& m_network;
    VertexPath m_path;
    std::vector<Triangle> m_triangles;  ///< over the nodes, those of an area
    std::vector<std::uint32_t> m_drawn; ///< the drawn triangle of each
    std::vector<PartedNode> m_parted;
    std::map<std::uint32_t, Side> m_sides; ///< by parted node
};

/// Any split opens the part that it runs on, and the fluid would run out.
void refuseToOpenFluids(const TissueModel& tissue, const EdgePath& path) {
    std::set<std::uint32_t> cut;
    for (const auto& [from, to] : path)
        cut.insert({from, to});
    for (const Cavity& cavity : tissue.cavities)
        for (const Triangle& triangle : cavity.triangles)
            if (std::any_of(triangle.begin(), triangle.end(), [&](auto node) { return cut.count(node) > 0; }))
                throw InvalidModel(
                    "it opens part " + std::to_string(cavity.part) +
                    " of the surface, which is filled: take the fluid and the pressure out of it, or "
                    "leave the split out");
}

} // namespace

SplitTissue splitAlong(const Topology& topology, const TissueModel& tissue, const EdgePath& path) {
    refuseToOpenFluids(tissue, path);
    return SurfaceSplitter(topology, tissue, path).split();
}

} // namespace esm
