#include "core/dynamics/contact/contact.h"

#include "core/dynamics/contact/body_pose.h"
#include "core/geometry/nearest_weights.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace esm {

namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr double smallTriangle = 0.25;       ///< circle around it, in radii of the sphere
constexpr double leastMovable = 0.2;         ///< share of a point that its movable nodes must carry
constexpr double projectionTolerance = 1e-9; ///< in radii
constexpr double planeSlack = 0.98;          ///< so that sliding along the sphere can turn the plane
constexpr int mostProjections = 30;
constexpr int mostParts = 64;

AlignedBox3d boxOf(const Triangle& triangle, const Vectors& positions) {
    AlignedBox3d box(positions[triangle[0]]);
    return box.extend(positions[triangle[1]]).extend(positions[triangle[2]]);
}

/// Squared radius of the smallest circle that holds a triangle.
double enclosingCircle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    std::array<double, 3> sides{(a - b).squaredNorm(), (b - c).squaredNorm(), (c - a).squaredNorm()};
    std::sort(sides.begin(), sides.end());
    if (sides[0] + sides[1] <= sides[2]) return sides[2] / 4;
    return sides[0] * sides[1] * sides[2] / (4 * (b - a).cross(c - a).squaredNorm());
}

Vector3d pointOf(const Contact& contact, const Vectors& positions) {
    Vector3d point = contact.arm;
    for (std::size_t i = 0; i < contact.count; ++i)
        point += contact.weights.at(i) * positions[contact.nodes.at(i)];
    return point;
}

/// Away from the sphere where the point now lies, but turned away from where it was only so far that the
/// plane kept free, `distance` from the centre, leaves its old place free as well: a push then takes speed
/// and gives none.
Vector3d outward(const Vector3d& after, const Vector3d& before, const SphereMove& sphere, double distance) {
    const Vector3d then = before - sphere.from, now = after - sphere.to;
    const double thenLength = then.norm(), nowLength = now.norm();
    if (!(thenLength > 0)) return nowLength > 0 ? Vector3d(now / nowLength) : Vector3d(Vector3d::UnitY());
    if (!(nowLength > 0)) return then / thenLength;
    const double angle = std::acos(std::clamp(then.dot(now) / (thenLength * nowLength), -1.0, 1.0));
    const double most = std::acos(std::min(1.0, planeSlack * distance / thenLength));
    if (angle <= most) return now / nowLength;
    const Vector3d turned = std::sin(angle - most) / thenLength * then + std::sin(most) / nowLength * now;
    const double length = turned.norm();
    return length > 1e-9 ? Vector3d(turned / length) : Vector3d(then / thenLength);
}

/// The same point has the same contact, whichever triangle it is found in.
Contact makeContact(Triangle nodes, const Vector3d& weights) {
    Contact contact{{noIndex, noIndex, noIndex}, {}, 0, {}, 0, 0};
    while (true) {
        const auto lowest =
            static_cast<std::size_t>(std::min_element(nodes.begin(), nodes.end()) - nodes.begin());
        if (nodes.at(lowest) == noIndex) return contact;
        const double weight = weights[static_cast<Eigen::Index>(lowest)];
        if (weight > 0) {
            contact.nodes.at(contact.count) = nodes.at(lowest);
            contact.weights.at(contact.count++) = weight;
        }
        nodes.at(lowest) = noIndex;
    }
}

double movableShare(const Contact& contact, const std::vector<char>& immovable) {
    double share = 0;
    for (std::size_t i = 0; i < contact.count; ++i)
        if (!immovable[contact.nodes.at(i)]) share += contact.weights.at(i);
    return share;
}

/// Of a body that moves as one piece: its point that is nearest to the sphere's centre, if that is inside.
std::vector<Contact> findBodyContact(const TouchedSurface& surface, const Vectors& before,
                                     const Vectors& after, const SphereMove& sphere) {
    const TouchedSurface::Body& body = *surface.body;
    const BodyPose pose(body, after);
    const Vector3d centre = pose.atRest(sphere.to);
    const AlignedBox3d range(centre - Vector3d::Constant(sphere.radius),
                             centre + Vector3d::Constant(sphere.radius));
    double least = sphere.radius;
    Vector3d nearest = centre;
    for (const Triangle& triangle : surface.triangles) {
        if (!range.intersects(boxOf(triangle, body.points))) continue;
        const Vector3d &a = body.points[triangle[0]], &b = body.points[triangle[1]],
                       &c = body.points[triangle[2]];
        const Vector3d weights = nearestWeights(centre, a, b, c);
        const Vector3d point = weights[0] * a + weights[1] * b + weights[2] * c;
        if (!((point - centre).norm() < least)) continue;
        least = (point - centre).norm();
        nearest = point;
    }
    if (!(least < sphere.radius)) return {};
    const Vector3d line = body.second - body.first;
    const double share = line.squaredNorm() > 0 ? (nearest - body.first).dot(line) / line.squaredNorm() : 0.5;
    Contact contact{{body.line.first, body.line.second, noIndex}, {1 - share, share, 0}, 2, {}, 0, 0};
    const Vector3d point = pose.now(nearest);
    contact.arm = point - pointOf(contact, after);
    contact.distance = sphere.radius;
    contact.depth = sphere.radius - least;
    contact.normal = outward(point, BodyPose(body, before).now(nearest), sphere, contact.distance);
    return {contact};
}

/// A box, m, and for how long, s, something may come into it.
struct Way {
    AlignedBox3d box;
    double duration;
};

/// How fast the surface near the way moves at most, m/s; nothing where none comes near.
std::optional<double> surfaceSpeed(const std::vector<Triangle>& surface, const Vectors& positions,
                                   const Vectors& velocities, const Way& way) {
    std::optional<double> squared;
    for (const Triangle& triangle : surface) {
        AlignedBox3d box = boxOf(triangle, positions);
        for (const std::uint32_t node : triangle)
            box.extend(positions[node] + way.duration * velocities[node]);
        if (!way.box.intersects(box)) continue;
        for (const std::uint32_t node : triangle)
            squared = std::max(squared.value_or(0), velocities[node].squaredNorm());
    }
    return squared ? std::optional(std::sqrt(*squared)) : std::nullopt;
}

/// How fast any point of a body may move, m/s; nothing where it stays away from the way.
std::optional<double> bodySpeed(const TouchedSurface::Body& body, const Vectors& positions,
                                const Vectors& velocities, const Way& way) {
    const BodyPose pose(body, positions);
    AlignedBox3d box;
    double longest = (body.second - body.first).norm();
    for (const Vector3d& point : body.points) {
        box.extend(pose.now(point));
        longest = std::max(longest, (point - body.first).norm());
    }
    const Vector3d &first = velocities[body.line.first], &second = velocities[body.line.second];
    const double line = (body.second - body.first).norm();
    const double turning = line > 0 ? (second - first).norm() * longest / line : 0;
    const double speed = std::max(first.norm(), second.norm()) + turning;
    const Vector3d reach = Vector3d::Constant(way.duration * speed);
    if (!way.box.intersects(AlignedBox3d(box.min() - reach, box.max() + reach))) return std::nullopt;
    return speed;
}

} // namespace

void turnOutward(Contact& contact, const Vectors& before, const Vectors& after, const SphereMove& sphere) {
    contact.normal = outward(pointOf(contact, after), pointOf(contact, before), sphere, contact.distance);
}

double depth(const Contact& contact, const Vectors& positions, const SphereMove& sphere) {
    return contact.distance - contact.normal.dot(pointOf(contact, positions) - sphere.to);
}

std::vector<Contact> findContacts(const TouchedSurface& surface, const std::vector<char>& immovable,
                                  const Vectors& before, const Vectors& after, const SphereMove& sphere) {
    if (surface.body) {
        std::vector<Contact> found = findBodyContact(surface, before, after, sphere);
        if (!found.empty() && movableShare(found.front(), immovable) < leastMovable) found.clear();
        return found;
    }
    // No corner of a small triangle is kept farther away than this.
    const double reach = sphere.radius * std::sqrt(1 + smallTriangle * smallTriangle);
    const AlignedBox3d range(sphere.to - Vector3d::Constant(reach), sphere.to + Vector3d::Constant(reach));
    std::map<std::array<std::uint32_t, 3>, Contact> contacts; // by their nodes
    const auto offer = [&](Contact contact, double distance) {
        const Vector3d point = pointOf(contact, after);
        contact.depth = distance - (point - sphere.to).norm();
        if (contact.depth <= 0 || movableShare(contact, immovable) < leastMovable) return;
        contact.distance = distance;
        contact.normal = outward(point, pointOf(contact, before), sphere, contact.distance);
        const auto [found, isNew] = contacts.try_emplace(contact.nodes, contact);
        if (!isNew && contact.distance > found->second.distance) found->second = contact;
    };
    for (const Triangle& triangle : surface.triangles) {
        if (!range.intersects(boxOf(triangle, after))) continue;
        const Vector3d &a = after[triangle[0]], &b = after[triangle[1]], &c = after[triangle[2]];
        const double circle = enclosingCircle(a, b, c);
        const bool isSmall = circle <= std::pow(smallTriangle * sphere.radius, 2);
        const double cornerDistance =
            isSmall ? std::sqrt(sphere.radius * sphere.radius + circle) : sphere.radius;
        for (const std::uint32_t node : triangle)
            offer({{node, noIndex, noIndex}, {1}, 1, {}, 0, 0}, cornerDistance);
        if (isSmall) continue;
        const Contact nearest = makeContact(triangle, nearestWeights(sphere.to, a, b, c));
        if (nearest.count > 1) offer(nearest, sphere.radius);
    }
    std::vector<Contact> result;
    result.reserve(contacts.size());
    for (const auto& [nodes, contact] : contacts)
        result.push_back(contact);
    return result;
}

double deepest(const std::vector<Contact>& found) {
    double depth = 0;
    for (const Contact& contact : found)
        depth = std::max(depth, contact.depth);
    return depth;
}

void mergeContacts(std::vector<Contact>& contacts, std::vector<Contact> found, std::size_t most) {
    std::stable_sort(found.begin(), found.end(),
                     [](const Contact& a, const Contact& b) { return a.depth > b.depth; });
    for (const Contact& contact : found) {
        if (contacts.size() >= most) return;
        const bool isNew = std::none_of(contacts.begin(), contacts.end(),
                                        [&](const Contact& other) { return other.nodes == contact.nodes; });
        if (isNew) contacts.push_back(contact);
    }
}

void projectOut(const TouchedSurface& surface, const std::vector<char>& immovable, const Vectors& before,
                const SphereMove& sphere, Vectors& positions) {
    for (int pass = 0; pass < mostProjections; ++pass) {
        const std::vector<Contact> found = findContacts(surface, immovable, before, positions, sphere);
        if (deepest(found) <= projectionTolerance * sphere.radius) return;
        for (const Contact& contact : found) {
            const double inside = depth(contact, positions, sphere);
            if (inside <= 0) continue;
            double squares = 0;
            for (std::size_t i = 0; i < contact.count; ++i)
                if (!immovable[contact.nodes.at(i)]) squares += contact.weights.at(i) * contact.weights.at(i);
            for (std::size_t i = 0; i < contact.count; ++i)
                if (!immovable[contact.nodes.at(i)])
                    positions[contact.nodes.at(i)] +=
                        inside * contact.weights.at(i) / squares * contact.normal;
        }
    }
}

int contactParts(const TouchedSurface& surface, const Vectors& positions, const Vectors& velocities,
                 const SphereMove& sphere, double duration) {
    AlignedBox3d path(sphere.from);
    path.extend(sphere.to);
    const Vector3d margin = Vector3d::Constant(1.5 * sphere.radius);
    path = AlignedBox3d(path.min() - margin, path.max() + margin);
    const Way way{path, duration};
    const std::optional<double> speed = surface.body
                                            ? bodySpeed(*surface.body, positions, velocities, way)
                                            : surfaceSpeed(surface.triangles, positions, velocities, way);
    if (!speed) return 1;
    const double motion = (sphere.to - sphere.from).norm() + duration * *speed;
    int parts = 1;
    while (parts < mostParts && motion > 0.5 * sphere.radius * parts)
        parts *= 2;
    return parts;
}

} // namespace esm
