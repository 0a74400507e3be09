#include "core/render/drawn_shape.h"

#include "core/support/angles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

using Eigen::Vector3d;

constexpr double farthestDrawn = 1e6; // m
constexpr int curvePoints = 96;

/// A circle of the unit sphere's space, carried to the ellipsoid.
std::vector<Vector3d> ellipsoidCurve(const Ellipsoid& ellipsoid, const Vector3d& centre, const Vector3d& axis,
                                     double radius) {
    const Vector3d first = axis.unitOrthogonal() * radius, second = axis.normalized().cross(first);
    std::vector<Vector3d> curve(curvePoints);
    for (int i = 0; i < curvePoints; ++i) {
        const double angle = 2 * pi * i / curvePoints;
        const Vector3d unit = centre + std::cos(angle) * first + std::sin(angle) * second;
        curve[static_cast<std::size_t>(i)] =
            ellipsoid.centre + ellipsoid.orientation * ellipsoid.radii.cwiseProduct(unit);
    }
    return curve;
}

} // namespace

bool isDrawable(const Vector3d& point) {
    return point.allFinite() && point.cwiseAbs().maxCoeff() < farthestDrawn;
}

std::vector<Vector3d> drawnNodes(const RenderScene& scene) {
    if (!scene.network && !scene.mesh) return {};
    const std::vector<Vector3d>& rest = scene.network ? scene.network->restPositions : scene.mesh->vertices;
    if (scene.nodePositions.size() != rest.size()) return rest;
    std::vector<Vector3d> nodes = scene.nodePositions;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (!isDrawable(nodes[i])) nodes[i] = rest[i];
    return nodes;
}

std::vector<Vector3d> drawnVertices(const RenderScene& scene, const std::vector<Vector3d>& nodes) {
    if (!scene.mesh) return {};
    if (!scene.network) return nodes;
    const std::vector<std::uint32_t>& vertexNodes = scene.network->vertexNodes;
    const auto isKnown = [&](std::uint32_t node) { return node < nodes.size(); };
    if (vertexNodes.size() != scene.mesh->vertices.size() ||
        !std::all_of(vertexNodes.begin(), vertexNodes.end(), isKnown))
        return scene.mesh->vertices;
    return drawnPositions(*scene.mesh, *scene.network, nodes);
}

std::array<Vector3d, 8> projectorBox(const Projector& projector, const Eigen::AlignedBox3d& shown) {
    double depth = 0.25 * std::max(projector.width, projector.height);
    if (!shown.isEmpty()) {
        for (int i = 0; i < 8; ++i) {
            const Vector3d corner = shown.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
            depth = std::max(depth, -(projector.pose.inverse() * corner).z() * 1.02);
        }
    }
    std::array<Vector3d, 8> corners;
    const double x = projector.width / 2, y = projector.height / 2;
    const std::array<Eigen::Vector2d, 4> face{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
    for (std::size_t i = 0; i < 8; ++i)
        corners[i] = projector.pose * Vector3d(face[i % 4].x(), face[i % 4].y(), i < 4 ? 0 : -depth);
    return corners;
}

std::vector<Vector3d> silhouette(const Ellipsoid& ellipsoid, const Vector3d& eye) {
    const Vector3d turned = ellipsoid.orientation.inverse() * (eye - ellipsoid.centre);
    const Vector3d unitEye = turned.cwiseQuotient(ellipsoid.radii);
    const double distance = unitEye.norm();
    if (!(distance > 1)) return {};
    // Tangents from the eye touch the unit sphere where point · eye = 1: a circle.
    const Vector3d axis = unitEye / distance;
    return ellipsoidCurve(ellipsoid, axis / distance, axis, std::sqrt(1 - 1 / (distance * distance)));
}

std::vector<Vector3d> rimSilhouette(const Ellipsoid& ellipsoid, double rim, const Vector3d& eye) {
    const Vector3d turned = ellipsoid.orientation.inverse() * (eye - ellipsoid.centre);
    const Vector3d unitEye = turned.cwiseQuotient(ellipsoid.radii);
    // Over the ellipsoid's point p with the normal n the rim ends at p + rim·n. The line of sight touches it
    // there where n · (p + rim·n − eye) = 0: for the unit sphere's point u of p, where this is 0.
    const auto facing = [&](const Vector3d& unit) {
        return unit.dot(unitEye) - 1 - rim * unit.cwiseQuotient(ellipsoid.radii).norm();
    };
    const double distance = unitEye.norm();
    if (!(distance > 1) || !(facing(unitEye / distance) > 0)) return {};
    const Vector3d axis = unitEye / distance, first = axis.unitOrthogonal(), second = axis.cross(first);
    std::vector<Vector3d> curve;
    for (int i = 0; i < curvePoints; ++i) {
        const double angle = 2 * pi * i / curvePoints;
        const Vector3d aside = std::cos(angle) * first + std::sin(angle) * second;
        const auto unitAt = [&](double tilt) {
            return Vector3d(std::cos(tilt) * axis + std::sin(tilt) * aside);
        };
        double seen = 0, hidden = pi / 2;
        for (int halving = 0; halving < 40; ++halving) {
            const double middle = (seen + hidden) / 2;
            (facing(unitAt(middle)) > 0 ? seen : hidden) = middle;
        }
        const Vector3d unit = unitAt(seen), normal = unit.cwiseQuotient(ellipsoid.radii).normalized();
        curve.emplace_back(ellipsoid.centre +
                           ellipsoid.orientation * (ellipsoid.radii.cwiseProduct(unit) + rim * normal));
    }
    return curve;
}

std::vector<Vector3d> greatCircle(const Ellipsoid& ellipsoid, int axis) {
    return ellipsoidCurve(ellipsoid, Vector3d::Zero(), Vector3d::Unit(axis), 1);
}

} // namespace esm
