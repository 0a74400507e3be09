#pragma once

#include "core/dynamics/contact/touched_surface.h"
#include "core/dynamics/spring_system.h"

#include <array>

namespace esm {

/// A sphere on its way during a step.
struct SphereMove {
    Eigen::Vector3d from, to; ///< m, centre
    double radius;            ///< m
};

/// A surface point that must not come nearer to the sphere's centre than `distance`.
struct Contact {
    std::array<std::uint32_t, 3> nodes; ///< the first `count` of them; then noIndex
    std::array<double, 3> weights;      ///< of the nodes in the point's motion; sum 1
    std::size_t count;
    Eigen::Vector3d normal; ///< away from the sphere
    double distance;        ///< m
    double depth;           ///< m inside, when found
    /// m, from the nodes' weighted mean to the point, as when found: a point of a body that moves as one
    /// piece
    Eigen::Vector3d arm = Eigen::Vector3d::Zero();
};

/// Where the surface, moved from `before` to `after`, is inside the sphere at its end. A triangle that is
/// small beside the sphere is kept out by its corners, which stay outside by as much as its middle would sink
/// in between; a larger one by its corners and its nearest point. Points that hang on `immovable` nodes by
/// more than four fifths are left out. In a fixed order. Of a body that moves as one piece the deepest point.
std::vector<Contact> findContacts(const TouchedSurface& surface, const std::vector<char>& immovable,
                                  const Vectors& before, const Vectors& after, const SphereMove& sphere);

/// Turns the normal to where the point now lies.
void turnOutward(Contact& contact, const Vectors& before, const Vectors& after, const SphereMove& sphere);

/// How deep the contact's point lies, m; negative outside.
double depth(const Contact& contact, const Vectors& positions, const SphereMove& sphere);

/// Of contacts as they were found, m; 0 without any.
double deepest(const std::vector<Contact>& found);

/// Adds those that are not among the contacts yet, the deepest first, up to `most` in all.
void mergeContacts(std::vector<Contact>& contacts, std::vector<Contact> found, std::size_t most);

/// Moves what is still inside out along the shortest way.
void projectOut(const TouchedSurface& surface, const std::vector<char>& immovable, const Vectors& before,
                const SphereMove& sphere, Vectors& positions);

/// Parts a step should be cut into so that neither the sphere nor tissue in its way, moving at `velocities`,
/// moves more than half a radius.
int contactParts(const TouchedSurface& surface, const Vectors& positions, const Vectors& velocities,
                 const SphereMove& sphere, double duration);

} // namespace esm
