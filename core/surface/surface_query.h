#pragma once

#include "core/geometry/triangle_mesh.h"

#include <memory>
#include <optional>

namespace esm {

struct Ray {
    Eigen::Vector3d origin;    ///< m
    Eigen::Vector3d direction; ///< any length > 0
};

struct RayHit {
    std::uint32_t triangle;
    Eigen::Vector3d barycentric; ///< weights of the triangle's three corners
    double distance;             ///< m, along the normalised direction
};

/// Rays against a surface whose vertices may move (bounding-volume tree, refitted by Embree).
class SurfaceQuery {
public:
    /// @throws InvalidModel when a position is not finite, a triangle names a missing vertex or memory runs
    /// out
    SurfaceQuery(const std::vector<Eigen::Vector3d>& positions, const std::vector<Triangle>& triangles);
    SurfaceQuery(SurfaceQuery&&) noexcept;
    SurfaceQuery& operator=(SurfaceQuery&&) noexcept;
    ~SurfaceQuery();

    /// Takes new positions of the same vertices.
    /// @throws InvalidModel when one is not finite or their number differs, what was before then stays; or
    /// when memory runs out
    void refit(const std::vector<Eigen::Vector3d>& positions);

    /// The first triangle that a ray meets, from either side.
    std::optional<RayHit> firstHit(const Ray& ray) const;

    /// The surface's point nearest to a point, its distance being the one between them; of points equally
    /// near that of the first triangle. Nothing for a place that is not finite and a surface without
    /// triangles.
    std::optional<RayHit> nearest(const Eigen::Vector3d& point) const;

    /// True when anything lies between the two points, `margin` (m) left free at both ends.
    bool isBlocked(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double margin) const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> m_implementation;
};

} // namespace esm
