#include "core/dynamics/contact/body_pose.h"
#include "core/dynamics/contact/contact.h"
#include "core/dynamics/contact/contact_point.h"
#include "core/dynamics/contact/triangle_points.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace esm {

namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

/// Circle around it, in radii of the collider. With the circle's radius ρ and corners at least √(r² + ρ²)
/// from the axis, the middle between them is at least r away. So corners alone do, at most 3 % of a radius
/// farther out.
constexpr double smallTriangle = 0.25;
/// Share of a point that its movable nodes must carry. To move the point by d, they go by d over their share:
/// five times as far, at most.
constexpr double leastMovable = 0.2;

AlignedBox3d boxAround(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    AlignedBox3d box(a);
    return box.extend(b).extend(c);
}

/// Where a collider reaches to, when what keeps away from its axis is `reach` (m) away.
class Reach {
public:
    Reach(const ColliderAxis& axis, double reach) : m_axis(axis), m_reach(reach) {
        m_box = AlignedBox3d(axis.at(-axis.half)).extend(axis.at(axis.half));
        m_box =
            AlignedBox3d(m_box.min() - Vector3d::Constant(reach), m_box.max() + Vector3d::Constant(reach));
    }

    /// False only of what is outside. The box around a slanting capsule is wide: there the ball around the
    /// other box is looked at too.
    bool meets(const AlignedBox3d& box) const {
        return m_box.intersects(box) && (m_axis.isPoint() || meetsBallAround(box));
    }

private:
    bool meetsBallAround(const AlignedBox3d& box) const {
        const Vector3d centre = box.center();
        const double farthest = m_reach + box.diagonal().norm() / 2;
        return (centre - m_axis.at(m_axis.nearest(centre))).squaredNorm() <= farthest * farthest;
    }

    const ColliderAxis& m_axis;
    double m_reach;
    AlignedBox3d m_box;
};

/// Squared radius of the smallest circle that holds a triangle: about its longest side where the angle
/// opposite is not acute, else through its corners, abc over four times the area.
double enclosingCircle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    std::array<double, 3> sides{(a - b).squaredNorm(), (b - c).squaredNorm(), (c - a).squaredNorm()};
    std::sort(sides.begin(), sides.end());
    if (sides[0] + sides[1] <= sides[2]) return sides[2] / 4;
    return sides[0] * sides[1] * sides[2] / (4 * (b - a).cross(c - a).squaredNorm());
}

/// A point by up to three nodes that are not of weight 0, the lowest first: the same point is the same,
/// whichever triangle it is found in.
struct NodePoint {
    std::array<std::uint32_t, 3> nodes{noIndex, noIndex, noIndex};
    std::array<double, 3> weights{};
    std::size_t count = 0;
};

NodePoint cornerPoint(std::uint32_t node) {
    return {{node, noIndex, noIndex}, {1}, 1};
}

NodePoint nodePoint(const Triangle& triangle, const Vector3d& weights) {
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return triangle.at(a) < triangle.at(b); });
    NodePoint point;
    for (const std::size_t corner : order) {
        const double weight = weights[static_cast<Eigen::Index>(corner)];
        if (!(weight > 0)) continue;
        point.nodes.at(point.count) = triangle.at(corner);
        point.weights.at(point.count++) = weight;
    }
    return point;
}

/// The contacts of one collider with triangles over the nodes. A point on an edge or a corner belongs to
/// several triangles and becomes one contact: it is known by its nodes and the part of the axis that it is
/// nearest to. All triangles are asked whether they come near, since all may have moved since the step
/// before.
class SurfaceSearch {
public:
    SurfaceSearch(const ColliderMove& move, std::size_t collider, const std::vector<char>& immovable,
                  const Vectors& before, const Vectors& after)
        : m_move(move), m_collider(collider), m_immovable(immovable), m_before(before), m_after(after),
          // No corner of a small triangle is kept farther away than this.
          m_reach(m_move.to, m_move.radius * std::sqrt(1 + smallTriangle * smallTriangle)) {}

    void lookAt(const Triangle& triangle) {
        const Vector3d *const a = &m_after[triangle[0]], *const b = &m_after[triangle[1]],
                              *const c = &m_after[triangle[2]];
        if (!m_reach.meets(boxAround(*a, *b, *c))) return;
        const TrianglePoints::Corners corners{*a, *b, *c};
        const double radius = m_move.radius, circle = enclosingCircle(corners[0], corners[1], corners[2]);
        const bool isSmall = circle <= std::pow(smallTriangle * radius, 2);
        const double cornerDistance = isSmall ? std::sqrt(radius * radius + circle) : radius;
        for (const std::uint32_t node : triangle)
            offer(cornerPoint(node), AxisPart::First, cornerDistance);
        if (isSmall) return;
        for (const auto& [weights, part] : TrianglePoints(m_move.to, corners))
            if (const NodePoint point = nodePoint(triangle, weights); point.count > 1)
                offer(point, part, radius);
    }

    bool meetsImmovable() const { return m_meetsImmovable; }

    void giveTo(std::vector<Contact>& contacts) {
        for (auto& [key, contact] : m_contacts)
            contacts.push_back(std::move(contact));
    }

private:
    void offer(const NodePoint& offered, AxisPart part, double distance) {
        Vector3d point = Vector3d::Zero();
        for (std::size_t i = 0; i < offered.count; ++i)
            point += offered.weights.at(i) * m_after[offered.nodes.at(i)];
        const double depth = distance - (point - m_move.to.at(m_move.to.nearest(point))).norm();
        if (depth <= 0) return;
        if (movableShare(offered) < leastMovable) {
            m_meetsImmovable = true;
            return;
        }
        const auto [found, isNew] = m_contacts.try_emplace({offered.nodes, part});
        if (!isNew && !(distance > found->second.distance)) return;
        found->second = {{}, m_collider, part, distance, depth, {Vector3d::Zero(), Vector3d::Zero()}};
        for (std::size_t i = 0; i < offered.count; ++i)
            found->second.shares.push_back({offered.nodes.at(i), offered.weights.at(i)});
        found->second.plane = contactPlane(m_move, pointOf(found->second, m_before), point, distance);
    }

    double movableShare(const NodePoint& point) const {
        double share = 0;
        for (std::size_t i = 0; i < point.count; ++i)
            if (!m_immovable[point.nodes.at(i)]) share += point.weights.at(i);
        return share;
    }

    AxisMove m_move;
    std::size_t m_collider;
    const std::vector<char>& m_immovable;
    const Vectors &m_before, &m_after;
    Reach m_reach;
    std::map<std::pair<std::array<std::uint32_t, 3>, AxisPart>, Contact> m_contacts;
    bool m_meetsImmovable = false;
};

/// The deepest point of a body that moves as one piece, for each part of a collider's axis. One point of each
/// part is enough: a rigid body cannot be dented, and moves out as a whole. The axis is taken to where the
/// body lies at rest, in place of all the body's points to where it is now.
class BodySearch {
public:
    BodySearch(const TouchedSurface& surface, const AxisMove& move, const Vectors& before,
               const Vectors& after)
        : m_body(*surface.body), m_move(move), m_before(m_body, before), m_after(m_body, after),
          m_positions(after), m_axis(axisAtRest()) {
        const Reach reach(m_axis, move.radius);
        for (const Triangle& triangle : surface.triangles) {
            const TrianglePoints::Corners corners{m_body.points[triangle[0]], m_body.points[triangle[1]],
                                                  m_body.points[triangle[2]]};
            if (reach.meets(boxAround(corners[0], corners[1], corners[2]))) lookAt(corners);
        }
    }

    std::vector<Contact> contacts(std::size_t collider) const {
        std::vector<Contact> contacts;
        for (const AxisPart part : {AxisPart::First, AxisPart::Second, AxisPart::Between})
            if (const auto& deepest = m_deepest.at(static_cast<std::size_t>(part)))
                contacts.push_back(contactOf(*deepest, part, collider));
        return contacts;
    }

private:
    struct Deepest {
        Vector3d atRest; ///< m
        double distance; ///< m, from the axis
    };

    ColliderAxis axisAtRest() const {
        const ColliderAxis& axis = m_move.to;
        const Vector3d middle = m_after.atRest(axis.middle);
        if (axis.isPoint()) return {middle, axis.direction, 0};
        return {middle, (m_after.atRest(axis.middle + axis.direction) - middle).normalized(), axis.half};
    }

    void lookAt(const TrianglePoints::Corners& corners) {
        for (const auto& [weights, part] : TrianglePoints(m_axis, corners))
            if (part != AxisPart::Between) take(weights, corners, part);
        if (m_axis.isPoint()) return;
        const Vector3d beside = nearestToLine(m_axis, corners);
        const Vector3d point = beside[0] * corners[0] + beside[1] * corners[1] + beside[2] * corners[2];
        if (std::abs(m_axis.foot(point)) < m_axis.half) take(beside, corners, AxisPart::Between);
    }

    void take(const Vector3d& weights, const TrianglePoints::Corners& corners, AxisPart part) {
        const Vector3d point = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
        const double distance = (point - m_axis.at(m_axis.nearest(point))).norm();
        std::optional<Deepest>& deepest = m_deepest.at(static_cast<std::size_t>(part));
        if (distance < (deepest ? deepest->distance : m_move.radius)) deepest = {point, distance};
    }

    Contact contactOf(const Deepest& deepest, AxisPart part, std::size_t collider) const {
        const Vector3d line = m_body.second - m_body.first;
        const double squared = line.squaredNorm();
        const double share = squared > 0 ? (deepest.atRest - m_body.first).dot(line) / squared : 0.5;
        const double radius = m_move.radius;
        Contact contact{{{m_body.line.first, 1 - share}, {m_body.line.second, share}},
                        collider,
                        part,
                        radius,
                        radius - deepest.distance,
                        {}};
        const Vector3d point = m_after.now(deepest.atRest);
        contact.arm = point - pointOf(contact, m_positions);
        contact.plane = contactPlane(m_move, m_before.now(deepest.atRest), point, radius);
        return contact;
    }

    const TouchedSurface::Body& m_body;
    const AxisMove& m_move;
    BodyPose m_before, m_after;
    const Vectors& m_positions; ///< after
    ColliderAxis m_axis;        ///< where the body lies at rest
    std::array<std::optional<Deepest>, 3> m_deepest;
};

double movableShare(const Contact& contact, const std::vector<char>& immovable) {
    double share = 0;
    for (const auto& [node, weight] : contact.shares)
        if (!immovable[node]) share += weight;
    return share;
}

} // namespace

FoundContacts findContacts(const TouchedSurface& surface, const std::vector<char>& immovable,
                           const Vectors& before, const Vectors& after,
                           const std::vector<ColliderMove>& colliders) {
    FoundContacts found{{}, std::vector<char>(colliders.size())};
    for (std::size_t collider = 0; collider < colliders.size(); ++collider) {
        if (!surface.body) {
            SurfaceSearch search(colliders[collider], collider, immovable, before, after);
            for (const Triangle& triangle : surface.triangles)
                search.lookAt(triangle);
            found.meetsImmovable[collider] = search.meetsImmovable();
            search.giveTo(found.contacts);
            continue;
        }
        const AxisMove move(colliders[collider]);
        for (Contact& contact : BodySearch(surface, move, before, after).contacts(collider)) {
            if (movableShare(contact, immovable) < leastMovable)
                found.meetsImmovable[collider] = 1;
            else
                found.contacts.push_back(std::move(contact));
        }
    }
    if (colliders.size() > 1) meetHalfway(found.contacts);
    return found;
}

} // namespace esm
