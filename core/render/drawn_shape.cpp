#include "core/render/drawn_shape.h"

#include "core/geometry/adjacency.h"
#include "core/support/angles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

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

/// Of the farthest point's depth: nearer than that, surface is beside or around the eye.
constexpr double nearShare = 0.2;

/// How far before a projector a box begins and ends; (0, 0) for an empty one.
std::pair<double, double> depthsOf(const Projector& projector, const Eigen::AlignedBox3d& box) {
    if (box.isEmpty()) return {0, 0};
    std::pair<double, double> depths{HUGE_VAL, -HUGE_VAL};
    for (int i = 0; i < 8; ++i) {
        const Vector3d corner = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
        const double depth = -(projector.pose.inverse() * corner).z();
        depths = {std::min(depths.first, depth), std::max(depths.second, depth)};
    }
    return depths;
}

Paint mixedPaint(const std::vector<Paint>& nodes, const VertexBinding& vertex) {
    std::array<double, 4> sum{};
    for (std::size_t place = 0; place < vertex.nodes.size(); ++place)
        for (std::size_t channel = 0; channel < 4 && vertex.nodes[place] < nodes.size(); ++channel)
            sum[channel] += vertex.shares[place] * nodes[vertex.nodes[place]][channel];
    Paint mixed{};
    for (std::size_t channel = 0; channel < 4; ++channel)
        mixed[channel] = static_cast<std::uint8_t>(std::lround(std::clamp(sum[channel], 0.0, 255.0)));
    return mixed;
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

std::vector<Paint> vertexPaint(const RenderScene& scene, std::size_t vertexCount) {
    if (!scene.nodePaint) return {};
    const std::vector<Paint>& nodes = *scene.nodePaint;
    const std::vector<std::uint32_t>* vertexNodes = scene.network ? &scene.network->vertexNodes : nullptr;
    if ((vertexNodes ? vertexNodes->size() : nodes.size()) != vertexCount) return {};
    const Binding* binding = scene.network && scene.network->binding ? &*scene.network->binding : nullptr;
    std::vector<Paint> paint(vertexCount);
    for (std::size_t i = 0; i < vertexCount; ++i) {
        if (binding && i < binding->vertices.size())
            paint[i] = mixedPaint(nodes, binding->vertices[i]);
        else if (const std::size_t node = vertexNodes ? (*vertexNodes)[i] : i; node < nodes.size())
            paint[i] = nodes[node];
    }
    return paint;
}

/// Closed, manifold, and turned outwards: then what faces away is always hidden by what faces the eye.
bool isSolid(const TriangleMesh& mesh) {
    const EdgeCounts counts = countEdges(sidesByEdge(mesh.triangles));
    return counts.isClosed() && counts.nonManifold == 0 && enclosedVolume(mesh) > 0;
}

/// A perspective photo is drawn before the organ, where nothing hides it. An eye that stands in the organ or
/// right before it has no such place: there a tenth of the farthest depth does.
double shownDepth(const Projector& projector, const Eigen::AlignedBox3d& organ) {
    if (projector.kind == ProjectorKind::Parallel) return 0;
    const auto [nearest, farthest] = depthsOf(projector, organ);
    if (!(farthest > 0)) return 0.1; // the organ lies behind
    return nearest > nearShare * farthest ? 0.9 * nearest : 0.5 * nearShare * farthest;
}

std::array<Vector3d, 8> projectorBox(const DrawnProjector& drawn, const Eigen::AlignedBox3d& shown) {
    const Projector& projector = drawn.projector;
    const auto front = photoCorners(projector, drawn.size(), drawn.depth);
    const double size = std::max((front[1] - front[0]).norm(), (front[3] - front[0]).norm());
    const double depth = std::max(drawn.depth + 0.25 * size, depthsOf(projector, shown).second * 1.02);
    const auto back = photoCorners(projector, drawn.size(), depth);
    std::array<Vector3d, 8> corners;
    std::copy(front.begin(), front.end(), corners.begin());
    std::copy(back.begin(), back.end(), corners.begin() + 4);
    return corners;
}

/// In the space in which the ellipsoid is the unit sphere (an affine map keeps tangents tangents) the eye
/// sees a circle: its points u satisfy u · eye = 1, so that it lies at 1 / |eye| along the axis with the
/// radius √(1 − 1/|eye|²). From within there is none.
std::vector<Vector3d> silhouette(const Ellipsoid& ellipsoid, const Vector3d& eye) {
    const Vector3d turned = ellipsoid.orientation.inverse() * (eye - ellipsoid.centre);
    const Vector3d unitEye = turned.cwiseQuotient(ellipsoid.radii);
    const double distance = unitEye.norm();
    if (!(distance > 1)) return {};
    // Tangents from the eye touch the unit sphere where point · eye = 1: a circle.
    const Vector3d axis = unitEye / distance;
    return ellipsoidCurve(ellipsoid, axis / distance, axis, std::sqrt(1 - 1 / (distance * distance)));
}

/// The rim lies at a constant distance over the ellipsoid and is no ellipsoid itself, so its outline has no
/// closed form. In each direction around the axis the tilt at which it turns away from the eye is found by
/// halving, forty times: to 10⁻¹² radian.
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
