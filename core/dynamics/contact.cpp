#include "core/dynamics/contact.h"

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
    Vector3d point = Vector3d::Zero();
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

} // namespace

void turnOutward(Contact& contact, const Vectors& before, const Vectors& after, const SphereMove& sphere) {
    contact.normal = outward(pointOf(contact, after), pointOf(contact, before), sphere, contact.distance);
}

double depth(const Contact& contact, const Vectors& positions, const SphereMove& sphere) {
    return contact.distance - contact.normal.dot(pointOf(contact, positions) - sphere.to);
}

std::vector<Contact> findContacts(const std::vector<Triangle>& surface, const std::vector<char>& immovable,
                                  const Vectors& before, const Vectors& after, const SphereMove& sphere) {
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
    for (const Triangle& triangle : surface) {
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

void projectOut(const std::vector<Triangle>& surface, const std::vector<char>& immovable,
                const Vectors& before, const SphereMove& sphere, Vectors& positions) {
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

int contactParts(const std::vector<Triangle>& surface, const Vectors& positions, const Vectors& velocities,
                 const SphereMove& sphere, double duration) {
    AlignedBox3d path(sphere.from);
    path.extend(sphere.to);
    const Vector3d margin = Vector3d::Constant(1.5 * sphere.radius);
    path = AlignedBox3d(path.min() - margin, path.max() + margin);
    double speed = 0;
    bool near = false;
    for (const Triangle& triangle : surface) {
        AlignedBox3d box = boxOf(triangle, positions);
        for (const std::uint32_t node : triangle)
            box.extend(positions[node] + duration * velocities[node]);
        if (!path.intersects(box)) continue;
        near = true;
        for (const std::uint32_t node : triangle)
            speed = std::max(speed, velocities[node].squaredNorm());
    }
    if (!near) return 1;
    const double motion = (sphere.to - sphere.from).norm() + duration * std::sqrt(speed);
    int parts = 1;
    while (parts < mostParts && motion > 0.5 * sphere.radius * parts)
        parts *= 2;
    return parts;
}

} // namespace esm
