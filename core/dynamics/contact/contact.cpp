#include "core/dynamics/contact/contact.h"

#include "core/dynamics/contact/contact_point.h"

#include <algorithm>

namespace esm {

namespace {

constexpr double projectionTolerance = 1e-9; ///< in radii
constexpr int mostProjections = 30;          ///< tissue that has nowhere to go is left as it is then

bool areSame(const Contact& a, const Contact& b) {
    const auto sameNode = [](const NodeShare& one, const NodeShare& other) { return one.node == other.node; };
    return a.collider == b.collider && a.part == b.part &&
           std::equal(a.shares.begin(), a.shares.end(), b.shares.begin(), b.shares.end(), sameNode);
}

/// Moves a contact's point out by as much as it is inside. A node of weight w goes by w / Σw² of that, in sum
/// the whole way; of all ways to share it out this has the least sum of squares.
void pushOut(const Contact& contact, const std::vector<char>& immovable, double inside, Vectors& positions,
             std::vector<NodePush>& pushes) {
    double squares = 0;
    for (const auto& [node, weight] : contact.shares)
        if (!immovable[node]) squares += weight * weight;
    for (const auto& [node, weight] : contact.shares) {
        if (immovable[node]) continue;
        const Eigen::Vector3d way = inside * weight / squares * contact.plane.normal;
        positions[node] += way;
        pushes.push_back({node, contact.collider, way});
    }
}

constexpr double opposite = -0.5; ///< cosine of 120°, from where on normals leave no way out to the side

bool shareANode(const Contact& a, const Contact& b) {
    return std::any_of(a.shares.begin(), a.shares.end(), [&](const NodeShare& one) {
        return std::any_of(b.shares.begin(), b.shares.end(),
                           [&](const NodeShare& other) { return one.node == other.node; });
    });
}

/// m, by which the planes of two contacts overlap where they face each other: both distances, less how far
/// the axes are apart along the direction in which they face. Only contacts that have a node in common press
/// the same tissue.
double overlapOf(const Contact& a, const Contact& b) {
    if (a.collider == b.collider || !shareANode(a, b)) return 0;
    if (a.plane.normal.dot(b.plane.normal) > opposite) return 0;
    const Eigen::Vector3d facing = (a.plane.normal - b.plane.normal).normalized();
    return std::max(0.0, a.distance + b.distance - facing.dot(b.plane.centre - a.plane.centre));
}

} // namespace

// Tissue between overlapping colliders cannot be outside of both. Impulses that try push ever harder against
// each other, and moving it out of one moves it into the other: it would be thrown. Where nothing can give
// way an instrument passes; here each does by half.
void meetHalfway(std::vector<Contact>& contacts) {
    std::vector<double> yields(contacts.size());
    for (std::size_t a = 0; a < contacts.size(); ++a)
        for (std::size_t b = a + 1; b < contacts.size(); ++b) {
            const double half = overlapOf(contacts[a], contacts[b]) / 2;
            yields[a] = std::max(yields[a], half);
            yields[b] = std::max(yields[b], half);
        }
    std::vector<Contact> left;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        Contact& contact = contacts[i];
        contact.distance -= yields[i];
        contact.depth -= yields[i];
        if (contact.depth > 0) left.push_back(std::move(contact));
    }
    contacts = std::move(left);
}

void turnOutward(Contact& contact, const Vectors& before, const Vectors& after,
                 const ColliderMove& collider) {
    contact.plane =
        contactPlane(AxisMove(collider), pointOf(contact, before), pointOf(contact, after), contact.distance);
}

double depth(const Contact& contact, const Vectors& positions) {
    return contact.distance - contact.plane.normal.dot(pointOf(contact, positions) - contact.plane.centre);
}

bool areClear(const std::vector<Contact>& found, const std::vector<ColliderMove>& colliders,
              double tolerance) {
    return std::all_of(found.begin(), found.end(), [&](const Contact& contact) {
        return contact.depth <= tolerance * radiusOf(colliders[contact.collider].shape);
    });
}

// The deepest first, since there may be more than are kept. Contacts of earlier rounds stay although they may
// be clear by now: without their impulses the tissue would come back.
void mergeContacts(std::vector<Contact>& contacts, std::vector<Contact> found, std::size_t most) {
    std::stable_sort(found.begin(), found.end(),
                     [](const Contact& a, const Contact& b) { return a.depth > b.depth; });
    for (Contact& contact : found) {
        if (contacts.size() >= most) return;
        const bool isNew = std::none_of(contacts.begin(), contacts.end(),
                                        [&](const Contact& other) { return areSame(other, contact); });
        if (isNew) contacts.push_back(std::move(contact));
    }
}

// What the impulses left inside, because they were solved to a tolerance or because there were too many
// contacts, is moved out point by point. Points share nodes, and one that goes out may take another in: so
// pass after pass looks again, until all are clear.
std::vector<NodePush> projectOut(const TouchedSurface& surface, const std::vector<char>& immovable,
                                 const Vectors& before, const std::vector<ColliderMove>& colliders,
                                 Vectors& positions) {
    std::vector<NodePush> pushes;
    for (int pass = 0; pass < mostProjections; ++pass) {
        const std::vector<Contact> found =
            findContacts(surface, immovable, before, positions, colliders).contacts;
        if (areClear(found, colliders, projectionTolerance)) break;
        for (const Contact& contact : found)
            if (const double inside = depth(contact, positions); inside > 0)
                pushOut(contact, immovable, inside, positions, pushes);
    }
    return pushes;
}

} // namespace esm
