#include "core/model/hinge.h"

#include "core/support/numbers.h"
#include "core/support/offenders.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Eigen::Vector3d;

/// Of the product of two lengths, below which the area between them is taken for none.
constexpr double leastArea = 1e-9;

bool areParallel(const Vector3d& first, const Vector3d& second) {
    return !(first.cross(second).norm() > leastArea * first.norm() * second.norm());
}

bool isEachOnce(std::array<std::uint32_t, 4> nodes) {
    std::sort(nodes.begin(), nodes.end());
    return std::adjacent_find(nodes.begin(), nodes.end()) == nodes.end();
}

} // namespace

// The places along both bars where these are closest solve two linear equations. At rest the vector between
// them stands on both bars and so along their cross product, of which it is a multiple: `restCurvature`.
//
// The hinge is opened by turning one corner about the edge. Which one it is, and what else turns with both,
// makes no difference: vector and cross product turn together.
std::optional<HingeShape> shapeOf(const Hinge& hinge, const std::vector<Vector3d>& restPositions) {
    const auto at = [&](std::size_t i) -> const Vector3d& { return restPositions[hinge.nodes[i]]; };
    const Vector3d edge = at(1) - at(0), corner = at(2) - at(0), across = at(3) - at(2);
    if (areParallel(edge, across) || areParallel(edge, corner) || areParallel(edge, at(3) - at(0))) return {};
    const Vector3d normal = edge.cross(across);
    const double square = normal.squaredNorm();
    const double onEdge = corner.cross(across).dot(normal) / square;
    const double onAcross = corner.cross(edge).dot(normal) / square;
    HingeShape shape{{onEdge - 1, -onEdge, 1 - onAcross, onAcross}, corner.dot(normal) / square, 0};
    const Vector3d turn = edge.normalized().cross(corner);
    shape.opening = (shape.weights[2] * turn + shape.restCurvature * edge.cross(turn)).norm();
    return shape;
}

std::vector<std::string> hingeProblems(const std::vector<Hinge>& hinges,
                                       const std::vector<Vector3d>& restPositions) {
    std::vector<std::string> problems;
    const auto exists = [&](const Hinge& hinge) {
        return std::all_of(hinge.nodes.begin(), hinge.nodes.end(),
                           [&](std::uint32_t node) { return node < restPositions.size(); });
    };
    const auto report = [&](const char* fault, const auto& isFaulty) {
        reportOffenders(problems, "hinge", fault,
                        placesWhere(hinges.size(), [&](std::size_t i) { return isFaulty(hinges[i]); }));
    };
    report("between nodes of which one does not exist", [&](const Hinge& hinge) { return !exists(hinge); });
    report("that names a node twice", [](const Hinge& hinge) { return !isEachOnce(hinge.nodes); });
    report("with a stiffness or viscosity that is no number from 0 to 10^30",
           [](const Hinge& hinge) { return !isAmount(hinge.stiffness) || !isAmount(hinge.viscosity); });
    report("whose triangles have no area or lie on each other", [&](const Hinge& hinge) {
        return exists(hinge) && isEachOnce(hinge.nodes) && !shapeOf(hinge, restPositions);
    });
    return problems;
}

} // namespace esm
