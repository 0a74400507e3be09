#include "core/solid/rigidity.h"

#include "core/dynamics/elimination/dissection.h"
#include "core/geometry/disjoint_sets.h"
#include "core/solid/rigid_core.h"
#include "core/support/errors.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <utility>

namespace esm {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using SparseMatrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

// Of the stiffest node. A rigid body of N nodes has its softest mode at about N^(-4/3) of that, held at three
// nodes: 10⁻⁷ for 200 000. Rounding leaves 10⁻¹³.
constexpr double softestMode = 1e-10;

/// The matrix of those nodes that are not known to be rigid together.
struct OpenNodes {
    std::vector<int> rows; ///< per node, its number among them; −1: it does not move
    std::vector<Vector3d> places;
    Entries entries; ///< lower half
};

void addBlock(OpenNodes& open, std::uint32_t one, std::uint32_t other, const Matrix3d& block) {
    const auto [column, row] = std::minmax({open.rows[one], open.rows[other]});
    if (column < 0) return;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (row != column || i >= j) open.entries.emplace_back(3 * row + i, 3 * column + j, block(i, j));
}

void addSprings(OpenNodes& open, const std::vector<Vector3d>& nodes,
                const std::vector<LatticeSpring>& springs) {
    for (const LatticeSpring& spring : springs) {
        const Vector3d along = (nodes[spring.second] - nodes[spring.first]).normalized();
        const Matrix3d block = spring.constant * along * along.transpose();
        addBlock(open, spring.first, spring.first, block);
        addBlock(open, spring.second, spring.second, block);
        addBlock(open, spring.first, spring.second, -block);
    }
}

/// The node of a body for which a measure is largest.
template<typename Measure>
std::uint32_t farthestOf(const std::vector<std::uint32_t>& body, const Measure& measure) {
    return *std::max_element(body.begin(), body.end(),
                             [&](auto one, auto other) { return measure(one) < measure(other); });
}

// One node is held, a second one across the line between both, a third one across the plane of all three:
// that takes each rigid motion and nothing else. They lie as far apart as they can, lest the body turn
// softly about them. Of a body on a line or of one node alone the last ones hold nothing.
void holdBody(OpenNodes& open, const std::vector<Vector3d>& nodes, const std::vector<std::uint32_t>& body,
              double constant) {
    const std::uint32_t first = body.front();
    const auto from = [&](std::uint32_t node) -> Vector3d { return nodes[node] - nodes[first]; };
    addBlock(open, first, first, constant * Matrix3d::Identity());
    const std::uint32_t second = farthestOf(body, [&](auto node) { return from(node).norm(); });
    if (second == first) return;
    const Vector3d line = from(second).normalized();
    addBlock(open, second, second, constant * (Matrix3d::Identity() - line * line.transpose()));
    const std::uint32_t third = farthestOf(body, [&](auto node) { return from(node).cross(line).norm(); });
    const Vector3d normal = from(third).cross(line);
    if (normal.norm() < 1e-9 * from(second).norm()) return;
    addBlock(open, third, third, constant * normal.normalized() * normal.normalized().transpose());
}

std::vector<std::vector<std::uint32_t>> bodiesOf(std::size_t nodeCount,
                                                 const std::vector<LatticeSpring>& springs) {
    DisjointSets sets(nodeCount);
    for (const LatticeSpring& spring : springs)
        sets.join(spring.first, spring.second);
    std::vector<std::vector<std::uint32_t>> ofNode(nodeCount), bodies;
    for (std::uint32_t node = 0; node < nodeCount; ++node)
        ofNode[sets.lowest(node)].push_back(node);
    for (std::vector<std::uint32_t>& body : ofNode)
        if (!body.empty()) bodies.push_back(std::move(body));
    return bodies;
}

double stiffestNode(std::size_t nodeCount, const std::vector<LatticeSpring>& springs) {
    std::vector<double> stiffness(nodeCount, 0.0);
    for (const LatticeSpring& spring : springs)
        for (const std::uint32_t node : {spring.first, spring.second})
            stiffness[node] += spring.constant;
    const auto stiffest = std::max_element(stiffness.begin(), stiffness.end());
    // Without springs any number will do.
    return stiffest != stiffness.end() && *stiffest > 0 ? *stiffest : 1;
}

OpenNodes openNodes(const std::vector<Vector3d>& nodes, const std::vector<char>& isRigid) {
    OpenNodes open;
    open.rows.assign(nodes.size(), -1);
    for (std::size_t node = 0; node < nodes.size(); ++node)
        if (!isRigid[node]) {
            open.rows[node] = static_cast<int>(open.places.size());
            open.places.push_back(nodes[node]);
        }
    return open;
}

/// With the rows in an order of little fill-in.
SparseMatrix ordered(const SparseMatrix& lower, const std::vector<Vector3d>& places) {
    std::vector<Vector3d> placesOfRows;
    for (const Vector3d& place : places)
        placesOfRows.insert(placesOfRows.end(), 3, place);
    const std::vector<int> order = dissect(RowGraph(lower), placesOfRows);
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation(lower.rows());
    for (std::size_t place = 0; place < order.size(); ++place)
        permutation.indices()[order[place]] = static_cast<int>(place);
    SparseMatrix result(lower.rows(), lower.cols());
    result.selfadjointView<Eigen::Lower>() = lower.selfadjointView<Eigen::Lower>().twistedBy(permutation);
    return result;
}

/// How many modes of the open nodes are softer than a constant, N/m.
std::size_t softModes(OpenNodes open, double constant) {
    if (open.places.empty()) return 0;
    const int size = static_cast<int>(3 * open.places.size());
    for (int i = 0; i < size; ++i)
        open.entries.emplace_back(i, i, -constant);
    SparseMatrix matrix(size, size);
    matrix.setFromTriplets(open.entries.begin(), open.entries.end());
    const Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>> factor(
        ordered(matrix, open.places));
    if (factor.info() != Eigen::Success)
        throw InvalidModel("whether the lattice is rigid could not be computed");
    return static_cast<std::size_t>((factor.vectorD().array() < 0).count());
}

} // namespace

// The number of negative pivots of K − σ is that of eigenvalues of K below σ (Sylvester 1852), so that one
// sparse factorisation counts floppy modes exactly, where a decomposition into all eigenvalues would take
// hours. K is that of the springs with the rigid motions of each body taken from it. Where a core of the body
// is seen to be rigid it is held as a whole, and its nodes need not be in the matrix: of a lattice with
// second neighbours hardly any is left. Any other body is held by six constraints. What is left below σ is
// floppy.
Rigidity rigidityOf(const std::vector<Vector3d>& nodes, const std::vector<LatticeSpring>& springs,
                    const Progress& progress) {
    reportProgress(progress, 0);
    const auto bodies = bodiesOf(nodes.size(), springs);
    const std::vector<char> isRigid = rigidCores(nodes, springs, bodies);
    reportProgress(progress, 0.1);
    OpenNodes open = openNodes(nodes, isRigid);
    addSprings(open, nodes, springs);
    const double stiffest = stiffestNode(nodes.size(), springs);
    for (const std::vector<std::uint32_t>& body : bodies)
        if (std::none_of(body.begin(), body.end(), [&](auto node) { return isRigid[node]; }))
            holdBody(open, nodes, body, stiffest);
    const std::size_t floppyModes = softModes(std::move(open), softestMode * stiffest);
    reportProgress(progress, 1);
    return {bodies.size(), floppyModes};
}

} // namespace esm
