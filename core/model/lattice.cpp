#include "core/model/lattice.h"

#include "core/geometry/sorted_by_vertex.h"
#include "core/support/numbers.h"
#include "core/support/offenders.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace esm {

double volumeOf(const Tetrahedron& tetrahedron, const std::vector<Eigen::Vector3d>& nodes) {
    const Eigen::Vector3d& origin = nodes[tetrahedron[0]];
    return (nodes[tetrahedron[1]] - origin)
               .cross(nodes[tetrahedron[2]] - origin)
               .dot(nodes[tetrahedron[3]] - origin) /
           6;
}

// Faces are written down by their sorted nodes, once for each side; one that stands alone is on the surface.
std::vector<OuterFace> outerFaces(const std::vector<Tetrahedron>& tetrahedra) {
    struct KeyedFace {
        Triangle key;
        OuterFace face;
    };
    std::vector<KeyedFace> faces;
    faces.reserve(4 * tetrahedra.size());
    for (const auto& [a, b, c, d] : tetrahedra)
        for (const OuterFace& face : {OuterFace{{a, c, b}, d}, OuterFace{{a, b, d}, c},
                                      OuterFace{{a, d, c}, b}, OuterFace{{b, c, d}, a}}) {
            Triangle key = face.nodes;
            std::sort(key.begin(), key.end());
            faces.push_back({key, face});
        }
    faces = sortedByVertex(
        faces, [](const KeyedFace& face) { return face.key[0]; },
        [](const KeyedFace& one, const KeyedFace& other) { return one.key < other.key; });
    std::vector<OuterFace> outer;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const bool isInner = (i > 0 && faces[i].key == faces[i - 1].key) ||
                             (i + 1 < faces.size() && faces[i].key == faces[i + 1].key);
        if (!isInner) outer.push_back(faces[i].face);
    }
    return outer;
}

std::vector<Triangle> outerTriangles(const std::vector<Tetrahedron>& tetrahedra) {
    std::vector<Triangle> triangles;
    for (const OuterFace& face : outerFaces(tetrahedra))
        triangles.push_back(face.nodes);
    return triangles;
}

std::vector<std::uint32_t> surfaceNodes(const Lattice& lattice) {
    std::vector<std::uint32_t> nodes;
    nodes.reserve(3 * lattice.surface.size());
    for (const Triangle& triangle : lattice.surface)
        nodes.insert(nodes.end(), triangle.begin(), triangle.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

std::vector<std::string> validate(const Lattice& lattice, const std::vector<Eigen::Vector3d>& nodes,
                                  std::size_t springCount) {
    std::vector<std::string> problems = fieldProblems(lattice.filling);
    if (lattice.tetrahedra.empty()) return {"has no tetrahedra"};
    std::vector<char> isCorner(nodes.size(), 0);
    for (const Tetrahedron& corners : lattice.tetrahedra)
        for (const std::uint32_t node : corners)
            if (node < nodes.size()) isCorner[node] = 1;
    reportOffenders(problems, "lattice node", "of no tetrahedron",
                    placesWhere(nodes.size(), [&](std::size_t node) { return isCorner[node] == 0; }));
    const auto isMissing = [&](std::uint32_t node) { return node >= nodes.size(); };
    const auto namesMissing = [&](const auto& corners) {
        return std::any_of(corners.begin(), corners.end(), isMissing);
    };
    reportOffenders(problems, "lattice tetrahedron",
                    "that is flat, turned inside out or without four nodes that exist",
                    placesWhere(lattice.tetrahedra.size(), [&](std::size_t i) {
                        const Tetrahedron& corners = lattice.tetrahedra[i];
                        return namesMissing(corners) || !(volumeOf(corners, nodes) > 0);
                    }));
    reportOffenders(
        problems, "outer triangle", "with a node that does not exist",
        placesWhere(lattice.surface.size(), [&](std::size_t i) { return namesMissing(lattice.surface[i]); }));
    if (lattice.springShares.size() != springCount)
        problems.push_back(std::to_string(lattice.springShares.size()) + " of the lattice's " +
                           std::to_string(springCount) + " springs have a share");
    reportOffenders(problems, "lattice spring", "whose share is not above 0, or beyond 1000",
                    placesWhere(lattice.springShares.size(), [&](std::size_t i) {
                        return !(lattice.springShares[i] > 0 && lattice.springShares[i] <= 1000);
                    }));
    return problems;
}

} // namespace esm
