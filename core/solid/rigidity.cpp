#include "core/solid/rigidity.h"

#include "core/geometry/disjoint_sets.h"
#include "core/support/errors.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <numeric>

namespace esm {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using SparseMatrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

// Of the stiffest node. A rigid body of N nodes has its softest mode at about N^(-4/3) of that, held at three
// nodes: 10⁻⁷ for 200 000. Rounding leaves 10⁻¹³.
constexpr double softestMode = 1e-10;

void addBlock(Entries& entries, std::uint32_t row, std::uint32_t column, const Matrix3d& block) {
    if (row < column) return;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (row != column || i >= j)
                entries.emplace_back(static_cast<int>(3 * row) + i, static_cast<int>(3 * column) + j,
                                     block(i, j));
}

void addSprings(Entries& entries, const std::vector<Vector3d>& nodes,
                const std::vector<LatticeSpring>& springs) {
    for (const LatticeSpring& spring : springs) {
        const Vector3d along = (nodes[spring.second] - nodes[spring.first]).normalized();
        const Matrix3d block = spring.constant * along * along.transpose();
        addBlock(entries, spring.first, spring.first, block);
        addBlock(entries, spring.second, spring.second, block);
        addBlock(entries, std::max(spring.first, spring.second), std::min(spring.first, spring.second),
                 -block);
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
void holdBody(Entries& entries, const std::vector<Vector3d>& nodes, const std::vector<std::uint32_t>& body,
              double constant) {
    const std::uint32_t first = body.front();
    const auto from = [&](std::uint32_t node) -> Vector3d { return nodes[node] - nodes[first]; };
    addBlock(entries, first, first, constant * Matrix3d::Identity());
    const std::uint32_t second = farthestOf(body, [&](auto node) { return from(node).norm(); });
    if (second == first) return;
    const Vector3d line = from(second).normalized();
    addBlock(entries, second, second, constant * (Matrix3d::Identity() - line * line.transpose()));
    const std::uint32_t third = farthestOf(body, [&](auto node) { return from(node).cross(line).norm(); });
    const Vector3d normal = from(third).cross(line);
    if (normal.norm() < 1e-9 * from(second).norm()) return;
    addBlock(entries, third, third, constant * normal.normalized() * normal.normalized().transpose());
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

} // namespace

// The number of negative pivots of K − σ is that of eigenvalues of K below σ (Sylvester 1852), so that one
// sparse factorisation counts floppy modes exactly, where a decomposition into all eigenvalues would take
// hours. K is that of the springs with six constraints per body, which take the rigid motions; what is left
// below σ is floppy. A rigid lattice leaves every pivot positive.
Rigidity rigidityOf(const std::vector<Vector3d>& nodes, const std::vector<LatticeSpring>& springs,
                    const Progress& progress) {
    reportProgress(progress, 0);
    Entries entries;
    addSprings(entries, nodes, springs);
    std::vector<double> stiffness(nodes.size(), 0.0);
    for (const LatticeSpring& spring : springs)
        for (const std::uint32_t node : {spring.first, spring.second})
            stiffness[node] += spring.constant;
    // Without springs any number will do.
    double stiffest = 0;
    for (const double constant : stiffness)
        stiffest = std::max(stiffest, constant);
    if (stiffest == 0) stiffest = 1;
    const auto bodies = bodiesOf(nodes.size(), springs);
    for (const std::vector<std::uint32_t>& body : bodies)
        holdBody(entries, nodes, body, stiffest);
    const auto size = static_cast<Eigen::Index>(3 * nodes.size());
    for (int i = 0; i < size; ++i)
        entries.emplace_back(i, i, -softestMode * stiffest);
    SparseMatrix matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    reportProgress(progress, 0.1);
    const Eigen::SimplicialLDLT<SparseMatrix> factor(matrix);
    if (factor.info() != Eigen::Success)
        throw InvalidModel("whether the lattice is rigid could not be computed");
    reportProgress(progress, 1);
    return {bodies.size(), static_cast<std::size_t>((factor.vectorD().array() < 0).count())};
}

} // namespace esm
