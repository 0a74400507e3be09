#include "core/solid/graded_cells.h"

#include "core/solid/lattice_sites.h"
#include "core/solid/parallel_nodes.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr int widest = 1 << mostDoublings;

/// Calls `visit` with each of the finest cubes in a box of them.
template<typename Visit> void forEachIn(const Vector3i& first, const Vector3i& end, const Visit& visit) {
    for (int z = first.z(); z < end.z(); ++z)
        for (int y = first.y(); y < end.y(); ++y)
            for (int x = first.x(); x < end.x(); ++x)
                visit(Vector3i(x, y, z));
}

/// Calls `visit` with the first of the finest cubes of each cube of a width, as the widest ones lie.
template<typename Visit> void forEachCube(const GradedCells& cells, int width, const Visit& visit) {
    forEachIn(Vector3i::Zero(), cells.grid.counts / width,
              [&](const Vector3i& cube) { visit(width * cube); });
}

void setDoublings(GradedCells& cells, const Vector3i& first, int width, int doublings) {
    forEachIn(first, first + Vector3i::Constant(width), [&](const Vector3i& cell) {
        cells.doublings[cells.grid.numberOf(cell)] = static_cast<std::uint8_t>(doublings);
    });
}

/// Whether each cube of a width lies deep enough to be as wide, in the order of `BoxGrid`.
std::vector<char> areDeep(const GradedCells& cells, int width, const BodyQuery& query,
                          const Progress& progress) {
    const BoxGrid cubes{cells.grid.counts / width}, corners{cubes.counts + Vector3i::Ones()};
    const double enough = leastDepth * width * cells.edge;
    const auto isDeep = [&](const Vector3i& halfEdges) {
        const Vector3d place = cells.placeOf(halfEdges);
        return query.contains(place) && query.nearest(place).distance >= enough;
    };
    ProgressParts parts(progress);
    std::vector<char> isDeepCorner(corners.size()), areDeep(cubes.size());
    forEachNode(corners.size(), parts.next(0.6),
                [&](std::size_t i) { isDeepCorner[i] = isDeep(2 * width * corners.placeAt(i)) ? 1 : 0; });
    forEachNode(cubes.size(), parts.rest(), [&](std::size_t i) {
        const Vector3i cube = cubes.placeAt(i);
        bool isCubeDeep = true;
        for (int corner = 0; corner < 8; ++corner) {
            const Vector3i at = cube + Vector3i(corner & 1, corner >> 1 & 1, corner >> 2);
            isCubeDeep = isCubeDeep && isDeepCorner[corners.numberOf(at)] != 0;
        }
        areDeep[i] = isCubeDeep && isDeep(width * (2 * cube + Vector3i::Ones())) ? 1 : 0;
    });
    return areDeep;
}

/// Whether a cube, or one at a face, an edge or a corner of it, is of less than half its width.
bool isBesideTooFine(const GradedCells& cells, const Vector3i& first, int doublings) {
    const Vector3i begin = (first - Vector3i::Ones()).cwiseMax(0),
                   end = (first + Vector3i::Constant((1 << doublings) + 1)).cwiseMin(cells.grid.counts);
    bool isFine = false;
    forEachIn(begin, end,
              [&](const Vector3i& cell) { isFine = isFine || cells.doublingsAt(cell) < doublings - 1; });
    return isFine;
}

// Of the cubes around an edge one alone may be finer, and all have to know of the corner in the edge's
// middle.
/// Whether some cube at an edge of this middle has a corner there: one that is finer than the edge.
bool isSplit(const GradedCells& cells, const Vector3i& middle, int doublings) {
    bool isFiner = false;
    const Vector3i after = middle / 2;
    forEachIn(after - Vector3i::Ones(), after + Vector3i::Ones(), [&](const Vector3i& cell) {
        isFiner = isFiner || (cells.grid.holds(cell) && cells.doublingsAt(cell) < doublings);
    });
    return isFiner;
}

/// A cube by its first finest one.
struct Cube {
    Vector3i first;
    int doublings;

    int edge() const { return 2 << doublings; } ///< in half edges
    Vector3i centre() const { return 2 * first + Vector3i::Constant(1 << doublings); }
};

Cube cubeAt(const GradedCells& cells, const Vector3i& cell) {
    const int doublings = cells.doublingsAt(cell), width = 1 << doublings;
    return {cell.unaryExpr([&](int x) { return x / width * width; }), doublings};
}

/// The four corners of a face, around it.
std::array<Vector3i, 4> faceOf(const Cube& cube, int axis, bool isUpper) {
    const Vector3i corner = 2 * cube.first + (isUpper ? cube.edge() : 0) * Vector3i::Unit(axis);
    const Vector3i u = cube.edge() * Vector3i::Unit((axis + 1) % 3),
                   v = cube.edge() * Vector3i::Unit((axis + 2) % 3);
    return {corner, corner + u, corner + u + v, corner + v};
}

void add(std::vector<GradedTetrahedron>& tetrahedra, GradedTetrahedron tetrahedron) {
    if (tetrahedron.volume() < 0) std::swap(tetrahedron.corners[2], tetrahedron.corners[3]);
    tetrahedra.push_back(tetrahedron);
}

/// Around the line between the middles of two alike, one at each edge of the face between them; two where a
/// finer cube splits the edge.
void addRing(const GradedCells& cells, const Cube& cube, const Cube& next, int axis,
             std::vector<GradedTetrahedron>& tetrahedra) {
    const std::array<Vector3i, 4> face = faceOf(cube, axis, true);
    for (std::size_t i = 0; i < 4; ++i) {
        const Vector3i &from = face[i], &to = face[(i + 1) % 4], middle = (from + to) / 2;
        const std::array<Vector3i, 4> whole{cube.centre(), next.centre(), from, to};
        if (cube.doublings == 0 || !isSplit(cells, middle, cube.doublings)) {
            add(tetrahedra, {whole, true, cube.doublings});
            continue;
        }
        add(tetrahedra, {{whole[0], whole[1], from, middle}, false, cube.doublings});
        add(tetrahedra, {{whole[0], whole[1], middle, to}, false, cube.doublings});
    }
}

/// Two from the middle of each of two cubes to the face of the finer one. They halve it from the middle of
/// the wider one's face, so that the four faces within that have a pattern of their own whatever lies beside.
void addPyramids(const Cube& cube, const Cube& wider, int axis, bool isUpper,
                 std::vector<GradedTetrahedron>& tetrahedra) {
    const std::array<Vector3i, 4> face = faceOf(cube, axis, isUpper);
    Vector3i middle = wider.centre();
    middle[axis] = face[0][axis];
    const auto start = static_cast<std::size_t>(std::find(face.begin(), face.end(), middle) - face.begin());
    const auto corner = [&](std::size_t i) { return face[(start + i) % 4]; };
    for (const Vector3i& apex : {cube.centre(), wider.centre()})
        for (const std::size_t i : {std::size_t{1}, std::size_t{2}})
            add(tetrahedra, {{apex, corner(0), corner(i), corner(i + 1)}, false, cube.doublings});
}

} // namespace

double GradedTetrahedron::volume() const {
    const auto side = [&](std::size_t i) -> Vector3d { return (corners[i] - corners[0]).cast<double>(); };
    return side(1).cross(side(2)).dot(side(3)) / 6;
}

// How deep a cube lies is asked of its corners and its middle. No place of a cube is farther from all of
// these than 0.56 of its width, so that no surface runs through one that is as deep as that. Of the widest
// ones those beside others of a quarter become eight; as there are no more than three widths, what was split
// splits no other.
GradedCells gradedCells(double edge, const ClosedBody& body, const BodyQuery& query,
                        const Progress& progress) {
    static_assert(mostDoublings == 2, "one pass over the widest then leaves neighbours of half at the least");
    const Eigen::AlignedBox3d box = boundingBox(body.surface.vertices);
    const Eigen::Array3d wanted = widest * ((box.sizes() / (widest * edge)).array().ceil() + 2);
    checkSiteCount(2 * wanted.prod(), edge * std::sqrt(3.0) / 2);
    // From a corner of the box, so that a block of whole cells is filled as it is.
    GradedCells cells{box.min() - Vector3d::Constant(widest * edge), edge, {wanted.cast<int>().matrix()}, {}};
    cells.doublings.assign(cells.grid.size(), 0);
    ProgressParts parts(progress);
    for (int doublings = 1; doublings <= mostDoublings; ++doublings) {
        const int width = 1 << doublings;
        const std::vector<char> deep = areDeep(cells, width, query, parts.nextOfRest(0.8));
        const BoxGrid cubes{cells.grid.counts / width};
        for (std::size_t i = 0; i < deep.size(); ++i)
            if (deep[i]) setDoublings(cells, width * cubes.placeAt(i), width, doublings);
    }
    forEachCube(cells, widest, [&](const Vector3i& first) {
        if (cells.doublingsAt(first) == mostDoublings && isBesideTooFine(cells, first, mostDoublings))
            setDoublings(cells, first, widest, mostDoublings - 1);
    });
    return cells;
}

// Two neighbours share a face, or one of the four parts of the wider one's. Each face is looked at once: from
// the lower of two alike, and from the finer of two others.
std::vector<GradedTetrahedron> tetrahedraAt(const GradedCells& cells, const Vector3i& cell) {
    std::vector<GradedTetrahedron> tetrahedra;
    const Cube cube = cubeAt(cells, cell);
    if (cube.first != cell) return tetrahedra;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool isUpper : {false, true}) {
            const Vector3i beside = cell + (isUpper ? 1 << cube.doublings : -1) * Vector3i::Unit(axis);
            if (!cells.grid.holds(beside)) continue;
            const Cube next = cubeAt(cells, beside);
            if (next.doublings == cube.doublings && isUpper) addRing(cells, cube, next, axis, tetrahedra);
            if (next.doublings > cube.doublings) addPyramids(cube, next, axis, isUpper, tetrahedra);
        }
    return tetrahedra;
}

} // namespace esm
