#pragma once

#include "core/dynamics/contact/collider_move.h"
#include "core/dynamics/contact/touched_surface.h"
#include "core/dynamics/spring_system.h"

#include <vector>

namespace esm {

/// How much of a node's motion a point takes part in.
struct NodeShare {
    std::uint32_t node;
    double weight;
    bool operator==(const NodeShare&) const = default;
};

/// The part of a collider's axis that a triangle's point is nearest to.
enum class AxisPart { First, Second, Between };

/// A surface point that must not come nearer to a collider's axis than `distance`.
struct Contact {
    std::vector<NodeShare> shares; ///< of the nodes in the point's motion, by rising node; sum 1
    std::size_t collider;          ///< its place among those of the step
    AxisPart part;
    double distance;    ///< m
    double depth;       ///< m inside, when found
    ContactPlane plane; ///< its normal away from the collider
    /// m, from the nodes' weighted mean to the point, as when found: a point of a body that moves as one
    /// piece
    Eigen::Vector3d arm = Eigen::Vector3d::Zero();
};

/// The contacts of a surface.
struct FoundContacts {
    std::vector<Contact> contacts;
    std::vector<char> meetsImmovable; ///< per collider: whether it met what cannot give way
};

/// Where the surface, moved from `before` to `after`, is inside colliders at the end of their moves, one
/// collider after the other. A triangle that is small beside a collider is kept out by its corners, which
/// stay outside by as much as its middle would sink in between; a larger one by its corners and by those of
/// its points that can lie deepest. Points that hang on `immovable` nodes by more than four fifths are left
/// out. In a fixed order. Of a body that moves as one piece the deepest point for each part of an axis.
FoundContacts findContacts(const TouchedSurface& surface, const std::vector<char>& immovable,
                           const Vectors& before, const Vectors& after,
                           const std::vector<ColliderMove>& colliders);

/// Where two colliders press from both sides and leave nothing between them, both keep only to the middle of
/// what they share. Contacts that lie beyond it then are left out.
void meetHalfway(std::vector<Contact>& contacts);

/// Turns the plane to where the point now lies.
void turnOutward(Contact& contact, const Vectors& before, const Vectors& after, const ColliderMove& collider);

/// How deep the contact's point lies, m; negative outside.
double depth(const Contact& contact, const Vectors& positions);

/// Whether all were found inside by no more than so many radii of their colliders.
bool areClear(const std::vector<Contact>& found, const std::vector<ColliderMove>& colliders,
              double tolerance);

/// Adds those that are not among the contacts yet, the deepest first, up to `most` in all.
void mergeContacts(std::vector<Contact>& contacts, std::vector<Contact> found, std::size_t most);

/// A node that was moved out of a collider.
struct NodePush {
    std::uint32_t node;
    std::size_t collider;
    Eigen::Vector3d way; ///< m
};

/// Moves what is still inside out along the shortest way; says how.
std::vector<NodePush> projectOut(const TouchedSurface& surface, const std::vector<char>& immovable,
                                 const Vectors& before, const std::vector<ColliderMove>& colliders,
                                 Vectors& positions);

/// Parts a step should be cut into so that neither a collider nor tissue in its way, moving at `velocities`,
/// moves more than half a radius.
int contactParts(const TouchedSurface& surface, const Vectors& positions, const Vectors& velocities,
                 const std::vector<ColliderMove>& colliders, double duration);

} // namespace esm
