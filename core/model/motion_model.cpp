#include "core/model/motion_model.h"

#include "core/support/angles.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace esm {

namespace {

using Eigen::Vector3d;

// Shares of the organ's length, as the uterus of 7 cm has them.
constexpr double innerDistance = 1.5 / 7, outerDistance = 0.5, outerRadius = 3.0 / 7;

/// The direction in which a surface extends the farthest from its middle, by area: the principal axis of the
/// largest moment. By area and not by vertices, since where a mesh is fine says nothing of the organ's shape.
/// An axis has two senses, of which the decomposition may give either; one is chosen, so that the same organ
/// always gets the same model.
Vector3d longDirection(const TriangleMesh& mesh, const Vector3d& centre) {
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Triangle& t : mesh.triangles) {
        const Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const Vector3d middle = (a + b + c) / 3 - centre;
        spread += (b - a).cross(c - a).norm() * middle * middle.transpose();
    }
    const Vector3d direction = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
    // Of the two senses the one that points up or, lying, along the first axis it has a share of.
    for (const Eigen::Index axis : {1, 0, 2})
        if (std::abs(direction[axis]) > 1e-9) return direction[axis] > 0 ? direction : Vector3d(-direction);
    return Vector3d::UnitY();
}

} // namespace

// Why tripods: a node at the end of three springs that do not lie in a plane is held in all three directions,
// by the fewest springs there can be. Two such nodes give the organ a place and a direction; the spring
// between them keeps their distance. A turn about their line is not held, nor felt, since the line has none.
SpringNetwork motionModel(const Vector3d& centre, const Vector3d& length) {
    SpringNetwork network;
    const double extent = length.norm();
    const Vector3d along = length / extent, front = -along.unitOrthogonal(), across = front.cross(along);
    for (const double side : {1.0, -1.0})
        network.restPositions.emplace_back(centre + side * innerDistance * length);
    for (const double side : {1.0, -1.0})
        for (int leg = 0; leg < 3; ++leg) {
            const double angle = 2 * pi * leg / 3 + (side > 0 ? pi / 2 : -pi / 2);
            const Vector3d out = std::cos(angle) * front + std::sin(angle) * across;
            network.restPositions.emplace_back(centre + side * outerDistance * length +
                                               outerRadius * extent * out);
        }
    const auto tie = [&network](std::uint32_t first, std::uint32_t second) {
        const auto& at = network.restPositions;
        network.springs.push_back({first, second, (at[first] - at[second]).norm()});
    };
    tie(motionModelLine.first, motionModelLine.second);
    for (std::size_t leg = 0; leg < motionModelFixed.size(); ++leg)
        tie(leg < 3 ? motionModelLine.first : motionModelLine.second, motionModelFixed.at(leg));
    return network;
}

SpringNetwork motionModelOf(const TriangleMesh& mesh) {
    const Vector3d middle = boundingBox(mesh.vertices).center(), direction = longDirection(mesh, middle);
    double least = 0, most = 0;
    for (const Vector3d& vertex : mesh.vertices) {
        least = std::min(least, direction.dot(vertex - middle));
        most = std::max(most, direction.dot(vertex - middle));
    }
    SpringNetwork network = motionModel(middle + (least + most) / 2 * direction, (most - least) * direction);
    network.binding = bindToLine(mesh.vertices.size(), motionModelLine);
    for (const Vector3d& vertex : mesh.vertices) {
        const auto& at = network.restPositions;
        const bool isFirst = (vertex - at[motionModelLine.first]).squaredNorm() <=
                             (vertex - at[motionModelLine.second]).squaredNorm();
        network.vertexNodes.push_back(isFirst ? motionModelLine.first : motionModelLine.second);
    }
    return network;
}

} // namespace esm
