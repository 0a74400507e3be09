#pragma once

#include "core/dynamics/block_entries.h"
#include "core/dynamics/spring_system.h"
#include "core/geometry/triangle_mesh.h"

#include <vector>

namespace esm {

/// What the pushes of a sphere on its way do, seen from the sphere.
struct PushAlong {
    double force = 0;     ///< N, along its way, on the tissue
    double stiffness = 0; ///< N/m, by which that grows on the way while the tissue stays
    Vectors coupling;     ///< N/m, by which the forces on the nodes fall on the way
};

/// Keeps the triangles of a surface out of a sphere by pushes at their nearest points, without friction: the
/// method of multipliers (Hestenes 1969, Powell 1969). A triangle that is g (m) inside is pushed with p +
/// ρ·g, never pulled; p is what pushed it when pushes were last updated. A hardness ρ then needs not be large
/// to leave nothing inside.
class SphereContacts {
public:
    /// @param immovable nodes that do not give way
    SphereContacts(std::vector<Triangle> triangles, std::vector<char> immovable, double radius);

    /// Hardness follows from what resists the motion of each node, N/m, roughly. Pushes stay.
    void setStiffness(std::vector<double> stiffness);

    /// Looks for the triangles that are near the sphere, and forgets those that are not. Whether one is
    /// inside by more than `tolerance` (m) that was not known.
    bool find(const Eigen::Vector3d& centre, const Vectors& positions, double tolerance);
    /// Whether the sphere met what cannot give way.
    bool meetsImmovable() const { return m_meetsImmovable; }

    /// J, that the pushes store: their forces are what it falls by.
    double energy(const Eigen::Vector3d& centre, const Vectors& positions) const;
    void addForces(const Eigen::Vector3d& centre, const Vectors& positions, Vectors& forces) const;
    void addStiffness(const Eigen::Vector3d& centre, const Vectors& positions, BlockEntries& entries) const;
    /// @param direction of length 1
    PushAlong along(const Eigen::Vector3d& direction, const Eigen::Vector3d& centre,
                    const Vectors& positions) const;
    /// N, of the sphere on the tissue, and the sum of all pushes' sizes.
    Eigen::Vector3d force(const Eigen::Vector3d& centre, const Vectors& positions) const;
    double pushes(const Eigen::Vector3d& centre, const Vectors& positions) const;

    /// Makes the pushes that act the ones to start from. N, by how much their force changes.
    double update(const Eigen::Vector3d& centre, const Vectors& positions);

private:
    struct Near {
        std::uint32_t triangle;
        double hardness; ///< N/m
        double push = 0; ///< N, to start from
    };
    /// A triangle's nearest point as it stands.
    struct Standing {
        Eigen::Vector3d weights;
        Eigen::Vector3d outward; ///< from the sphere's centre, of length 1
        double fromCentre;       ///< m
        double push;             ///< N
    };
    Standing standing(const Near& near, const Eigen::Vector3d& centre, const Vectors& positions) const;
    const Triangle& cornersOf(const Near& near) const { return m_triangles[near.triangle]; }
    double hardnessOf(const Triangle& triangle) const;
    bool givesWay(const Triangle& triangle, const Eigen::Vector3d& weights) const;

    std::vector<Triangle> m_triangles;
    std::vector<char> m_immovable;
    std::vector<double> m_stiffness;
    double m_radius;
    std::vector<Near> m_near; ///< by rising triangle
    bool m_meetsImmovable = false;
};

} // namespace esm
