#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/support/fields.h"
#include "core/support/words.h"

#include <array>
#include <string>
#include <vector>

namespace esm {

/// How the nodes that fill a body are laid out, and which of them springs join. The spacing of a lattice is
/// the distance of nearest neighbours, of a graded one at the surface; its cube's edge a is 1, 2/√3 or 4/√3
/// of that. A wall of prisms fills no more than what lies beneath the surface, which may be open.
enum class LatticeKind {
    Cubic,       ///< cubes with the diagonals of their faces, all of one constant: isotropic
    BodyCentred, ///< 8 neighbours of constant c and 6 of 2/3 c: isotropic
    Graded,      ///< body-centred, its cubes two and four times as wide deep within
    Diamond,     ///< 4 neighbours and 12 second ones of one constant [R 3.3.1.2]
    BareDiamond, ///< the source's: 4 neighbours alone [R algorithm 3.3]. Floppy: it resists no shear
    Prisms       ///< a wall: a prism of three tetrahedra under each triangle [R 3.3.2]
};
template<>
inline constexpr auto wordsOf<LatticeKind> = std::array{Word{LatticeKind::Cubic, "cubic"},
                                                        Word{LatticeKind::BodyCentred, "body-centred"},
                                                        Word{LatticeKind::Graded, "graded"},
                                                        Word{LatticeKind::Diamond, "diamond"},
                                                        Word{LatticeKind::BareDiamond, "bare-diamond"},
                                                        Word{LatticeKind::Prisms, "prisms"}};

inline constexpr int mostWallLayers = 8;

/// What to fill a body with.
struct LatticeFilling {
    LatticeKind kind = LatticeKind::BodyCentred;
    double spacing = 0;       ///< of nearest neighbours of a lattice, m; above 0
    double wallThickness = 0; ///< of prisms, m; above 0
    int layers = 1;           ///< of prisms, one beneath the other

    bool operator==(const LatticeFilling&) const = default;
};

constexpr bool isWall(const LatticeFilling& filling) {
    return filling.kind == LatticeKind::Prisms;
}

template<>
inline constexpr auto fieldsOf<LatticeFilling> = fieldTable(
    field("kind", &LatticeFilling::kind),
    field("spacing", &LatticeFilling::spacing, positiveLimits("the lattice's spacing", "m"))
        .onlyWhere([](const LatticeFilling& filling) { return !isWall(filling); }),
    field("wallThickness", &LatticeFilling::wallThickness, positiveLimits("the thickness of the wall", "m"))
        .onlyWhere(isWall),
    field("layers", &LatticeFilling::layers, Limits<int>{"the number of layers", 1, mostWallLayers})
        .onlyWhere(isWall));

using Tetrahedron = std::array<std::uint32_t, 4>; ///< node indices, in positive order

/// Volume of a tetrahedron, m³; negative where it is turned inside out.
double volumeOf(const Tetrahedron& tetrahedron, const std::vector<Eigen::Vector3d>& nodes);

/// A face of a lattice's surface, and the node of its tetrahedron that lies within.
struct OuterFace {
    Triangle nodes; ///< facing outwards
    std::uint32_t inner;
};

/// The faces of tetrahedra that have a neighbour on one side alone, by their nodes' numbers.
std::vector<OuterFace> outerFaces(const std::vector<Tetrahedron>& tetrahedra);
std::vector<Triangle> outerTriangles(const std::vector<Tetrahedron>& tetrahedra);

/// More than a million nodes have.
inline constexpr std::size_t mostTetrahedra = 10'000'000;

/// What fills a body, beside the nodes and springs that are the network's. Its nodes at the surface carry
/// what instruments touch; all of them carry what is drawn.
struct Lattice {
    LatticeFilling filling;              ///< that was asked for
    std::vector<Tetrahedron> tetrahedra; ///< over the nodes, face to face
    std::vector<Triangle> surface;       ///< `outerTriangles()` of them
    /// Of each spring of the network: its constant over that between nearest neighbours within the lattice,
    /// of a wall of prisms over that of a net which is as stiff as the wall.
    std::vector<double> springShares;
};

/// The nodes at the surface of a lattice, in order, each once.
std::vector<std::uint32_t> surfaceNodes(const Lattice& lattice);

/// Every problem of a lattice over nodes and springs. Empty when its tissue can be evaluated.
std::vector<std::string> validate(const Lattice& lattice, const std::vector<Eigen::Vector3d>& nodes,
                                  std::size_t springCount);

} // namespace esm
