#include "core/solid/unit_cell.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace esm {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

// Cells are described on a grid of quarters of their edge, so that places are whole numbers and equal where
// they are the same.
constexpr int quarters = 4;

using GridTetrahedron = std::array<Vector3i, 4>;

/// A kind of neighbour: how far, and the constant of the springs to all of them.
struct NeighbourShell {
    double distance; ///< in spacings
    double constant; ///< relative
};

struct CellPlan {
    double edge; ///< in spacings
    std::vector<Vector3i> sites;
    std::vector<NeighbourShell> shells;
    std::vector<GridTetrahedron> tetrahedra;
};

// Each cube is a tetrahedron on every other of its corners, and one at each corner that is left. All edges
// are then edges and face diagonals of cubes, which are springs. The next cube takes the other corners, so
// that both have the same diagonal in the face between them.
CellPlan cubicPlan() {
    CellPlan plan{2, {}, {{1, 1}, {std::sqrt(2.0), 1}}, {}};
    for (int corner = 0; corner < 8; ++corner) {
        const Vector3i cube(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
        plan.sites.push_back(2 * cube);
        const auto at = [&](int x, int y, int z) -> Vector3i {
            const Vector3i within(x, y, z);
            const Vector3i turned = cube.sum() % 2 == 0 ? within : Vector3i(Vector3i::Ones() - within);
            return 2 * (cube + turned);
        };
        plan.tetrahedra.push_back({at(0, 0, 0), at(1, 1, 0), at(1, 0, 1), at(0, 1, 1)});
        plan.tetrahedra.push_back({at(1, 0, 0), at(0, 0, 0), at(1, 1, 0), at(1, 0, 1)});
        plan.tetrahedra.push_back({at(0, 1, 0), at(0, 0, 0), at(1, 1, 0), at(0, 1, 1)});
        plan.tetrahedra.push_back({at(0, 0, 1), at(0, 0, 0), at(1, 0, 1), at(0, 1, 1)});
        plan.tetrahedra.push_back({at(1, 1, 1), at(1, 1, 0), at(1, 0, 1), at(0, 1, 1)});
    }
    return plan;
}

// Four tetrahedra lie around the line from a cube's centre to that of the next, one at each edge of the face
// between them. All are congruent.
CellPlan bodyCentredPlan() {
    const double edge = 2 / std::sqrt(3.0);
    CellPlan plan{edge, {{0, 0, 0}, {2, 2, 2}}, {{1, 1}, {edge, 2.0 / 3}}, {}};
    for (int axis = 0; axis < 3; ++axis) {
        const Vector3i along = quarters * Vector3i::Unit(axis), centre = Vector3i::Constant(2);
        const Vector3i u = quarters * Vector3i::Unit((axis + 1) % 3),
                       v = quarters * Vector3i::Unit((axis + 2) % 3);
        const std::array<Vector3i, 4> face{along, along + u, along + u + v, along + v};
        for (std::size_t side = 0; side < 4; ++side)
            plan.tetrahedra.push_back({centre, centre + along, face[side], face[(side + 1) % 4]});
    }
    return plan;
}

// Diamond is two face-centred lattices, the second in every other tetrahedral hole of the first. The first
// one's tetrahedra and octahedra fill space: a tetrahedron with a node inside becomes four, an octahedron
// four around its upright diagonal, which is no spring.
CellPlan diamondPlan(bool withSecondNeighbours) {
    const double edge = 4 / std::sqrt(3.0);
    CellPlan plan{edge, {}, {{1, 1}}, {}};
    if (withSecondNeighbours) plan.shells.push_back({edge / std::sqrt(2.0), 1});
    const std::array<Vector3i, 4> corners{Vector3i(1, 1, 1), Vector3i(1, -1, -1), Vector3i(-1, 1, -1),
                                          Vector3i(-1, -1, 1)};
    for (const Vector3i& node :
         {Vector3i(0, 0, 0), Vector3i(0, 2, 2), Vector3i(2, 0, 2), Vector3i(2, 2, 0)}) {
        const Vector3i inner = node + Vector3i::Ones(), empty = node - Vector3i::Ones(),
                       middle = node + Vector3i::Constant(2);
        plan.sites.push_back(node);
        plan.sites.push_back(inner);
        GridTetrahedron hole;
        for (std::size_t i = 0; i < 4; ++i) {
            hole[i] = empty + corners[i];
            GridTetrahedron part;
            for (std::size_t j = 0; j < 4; ++j)
                part[j] = i == j ? inner : Vector3i(inner - corners[j]);
            plan.tetrahedra.push_back(part);
        }
        plan.tetrahedra.push_back(hole);
        const std::array<Vector3i, 4> ring{Vector3i(2, 0, 0), Vector3i(0, 2, 0), Vector3i(-2, 0, 0),
                                           Vector3i(0, -2, 0)};
        for (std::size_t side = 0; side < 4; ++side)
            plan.tetrahedra.push_back({middle - 2 * Vector3i::UnitZ(), middle + 2 * Vector3i::UnitZ(),
                                       middle + ring[side], middle + ring[(side + 1) % 4]});
    }
    return plan;
}

CellPlan planOf(LatticeKind kind) {
    switch (kind) {
    case LatticeKind::Cubic:
        return cubicPlan();
    case LatticeKind::BodyCentred:
    case LatticeKind::Graded:
        return bodyCentredPlan();
    case LatticeKind::Diamond:
        return diamondPlan(true);
    case LatticeKind::BareDiamond:
    case LatticeKind::Prisms: // which has no cell
        break;
    }
    return diamondPlan(false);
}

// Of a place its cell is that of its quarters rounded down, and the site what is left; every corner of every
// tetrahedron is a site, which a test asks.
/// The site at a place of the grid.
CellSite siteAt(const CellPlan& plan, const Vector3i& place) {
    const Vector3i cell =
        place.unaryExpr([](int x) { return x >= 0 ? x / quarters : (x - quarters + 1) / quarters; });
    const auto found = std::find(plan.sites.begin(), plan.sites.end(), place - quarters * cell);
    return {static_cast<std::uint32_t>(found - plan.sites.begin()), cell};
}

/// Every spring once: of the two directions that whose first coordinate other than 0 is positive.
std::vector<CellSpring> springsOf(const CellPlan& plan, const UnitCell& cell) {
    std::vector<CellSpring> springs;
    for (std::uint32_t first = 0; first < cell.sites.size(); ++first)
        for (int place = 0; place < 27; ++place)
            for (std::uint32_t other = 0; other < cell.sites.size(); ++other) {
                const CellSite second{other,
                                      Vector3i(place % 3, place / 3 % 3, place / 9) - Vector3i::Ones()};
                const Vector3i way = plan.sites[other] + quarters * second.cell - plan.sites[first];
                const bool isForward =
                    way.x() != 0 ? way.x() > 0 : (way.y() != 0 ? way.y() > 0 : way.z() > 0);
                const double length = plan.edge / quarters * way.cast<double>().norm();
                for (const NeighbourShell& shell : plan.shells)
                    if (isForward && std::abs(length - shell.distance) < 1e-9)
                        springs.push_back({first, second, shell.constant});
            }
    return springs;
}

double volumeOf(const UnitCell& cell, const std::array<CellSite, 4>& corners) {
    const Vector3d origin = cell.placeOf(corners[0]);
    return (cell.placeOf(corners[1]) - origin)
               .cross(cell.placeOf(corners[2]) - origin)
               .dot(cell.placeOf(corners[3]) - origin) /
           6;
}

/// A tetrahedron of this cell or one near it, ready to be asked for points.
struct PlacedTetrahedron {
    std::size_t number;
    Vector3i cell;
    Vector3d origin;
    Eigen::Matrix3d toWeights;
    int samples = 0;

    bool holds(const Vector3d& point) const {
        const Vector3d weights = toWeights * (point - origin);
        return weights.minCoeff() >= 0 && weights.sum() <= 1;
    }

    /// Whether a point within `radius` of a segment may lie in it: none does where one of its faces has all
    /// of them outside.
    bool mayHold(const Vector3d& from, const Vector3d& along, double radius) const {
        const Eigen::RowVector3d toLast = -toWeights.colwise().sum();
        const Vector3d first = toWeights * (from - origin), second = first + toWeights * along;
        const Vector3d margins = radius * toWeights.rowwise().norm();
        return (first.cwiseMax(second) + margins).minCoeff() >= 0 &&
               std::min(first.sum(), second.sum()) - radius * toLast.norm() <= 1;
    }
};

/// All that come near a segment.
std::vector<PlacedTetrahedron> tetrahedraNear(const UnitCell& cell, const Vector3d& from,
                                              const Vector3d& along) {
    constexpr double distance = 0.01; // in spacings
    std::vector<PlacedTetrahedron> near;
    const Eigen::AlignedBox3d reach(from.cwiseMin(from + along).array() - distance,
                                    from.cwiseMax(from + along).array() + distance);
    for (std::size_t number = 0; number < cell.tetrahedra.size(); ++number)
        for (int place = 0; place < 125; ++place) {
            const Vector3i by = Vector3i(place % 5, place / 5 % 5, place / 25) - Vector3i::Constant(2);
            std::array<Vector3d, 4> corners;
            Eigen::AlignedBox3d box;
            for (std::size_t i = 0; i < 4; ++i) {
                corners[i] = cell.placeOf(cell.tetrahedra[number].corners[i]) + cell.edge * by.cast<double>();
                box.extend(corners[i]);
            }
            if (!box.intersects(reach)) continue;
            Eigen::Matrix3d sides;
            sides << corners[1] - corners[0], corners[2] - corners[0], corners[3] - corners[0];
            const PlacedTetrahedron placed{number, by, corners[0], sides.inverse()};
            if (placed.mayHold(from, along, distance)) near.push_back(placed);
        }
    return near;
}

// A spring belongs to the tetrahedra that a thin tube around it runs through, to each by its part of the
// tube. So one in a flat face of a body keeps half its constant, and one along an edge of a block a quarter,
// which leaves a body cut out of the lattice as stiff as its volume says. The tube is sampled, to a degree
// around; the sum of a spring's shares is exact for any sampling.
void shareSpring(UnitCell& cell, const CellSpring& spring) {
    const Vector3d from = cell.sites[spring.first], along = cell.placeOf(spring.second) - from;
    const Vector3d u = along.unitOrthogonal(), v = along.normalized().cross(u);
    constexpr int stations = 6, angles = 360;
    constexpr double radius = 1e-3; // in spacings
    std::vector<PlacedTetrahedron> near = tetrahedraNear(cell, from, along);
    int all = 0;
    for (int sample = 0; sample < stations * angles; ++sample) {
        const int station = sample / angles, step = sample % angles;
        const double angle = 2 * M_PI * (step + 0.31) / angles;
        const Vector3d point = from + along * ((station + 0.47) / stations) +
                               radius * (std::cos(angle) * u + std::sin(angle) * v);
        for (PlacedTetrahedron& tetrahedron : near)
            if (tetrahedron.holds(point)) {
                ++tetrahedron.samples;
                ++all;
            }
    }
    for (const PlacedTetrahedron& tetrahedron : near)
        if (tetrahedron.samples > 0)
            cell.tetrahedra[tetrahedron.number].shares.push_back(
                {{spring.first, -tetrahedron.cell},
                 {spring.second.site, spring.second.cell - tetrahedron.cell},
                 spring.constant * tetrahedron.samples / all,
                 along.norm()});
}

UnitCell cellOf(const CellPlan& plan) {
    UnitCell cell{plan.edge, {}, {}, {}};
    for (const Vector3i& site : plan.sites)
        cell.sites.emplace_back(plan.edge / quarters * site.cast<double>());
    cell.springs = springsOf(plan, cell);
    for (const GridTetrahedron& places : plan.tetrahedra) {
        CellTetrahedron tetrahedron;
        for (std::size_t i = 0; i < 4; ++i)
            tetrahedron.corners[i] = siteAt(plan, places[i]);
        if (volumeOf(cell, tetrahedron.corners) < 0)
            std::swap(tetrahedron.corners[2], tetrahedron.corners[3]);
        tetrahedron.volume = volumeOf(cell, tetrahedron.corners);
        cell.tetrahedra.push_back(std::move(tetrahedron));
    }
    for (const CellSpring& spring : cell.springs)
        shareSpring(cell, spring);
    return cell;
}

} // namespace

const UnitCell& unitCellOf(LatticeKind kind) {
    static const std::map<LatticeKind, UnitCell> cells = [] {
        std::map<LatticeKind, UnitCell> made;
        for (const auto& [each, word] : wordsOf<LatticeKind>)
            if (each != LatticeKind::Prisms) made.emplace(each, cellOf(planOf(each)));
        return made;
    }();
    return cells.at(kind);
}

} // namespace esm
