#pragma once

#include "core/geometry/surface_spot.h"
#include "core/render/renderer.h"
#include "core/surface/surface_query.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace esm {

/// A place on the organ that goes where the surface carries it: in a triangle, or a node of a model without
/// one.
struct CarriedPlace {
    std::array<std::uint32_t, 3> corners; ///< vertices, or the node thrice
    Eigen::Vector3d weights;              ///< of the corners
};
/// Where it is among vertices, or nodes, at these positions, m.
Eigen::Vector3d pointOf(const CarriedPlace& place, const std::vector<Eigen::Vector3d>& positions);

struct PickedPoint {
    std::uint32_t node;           ///< that carries most of the nearest corner
    Eigen::Vector3d point;        ///< m
    Eigen::Vector3d nodePosition; ///< m
    SurfaceSpot spot;             ///< the same on the organ at rest, the viewer being outside
    Eigen::Vector3d normal;       ///< of the surface at rest, as its triangle turns; zero without a surface
    CarriedPlace carried;
};

/// How far beside a ray a node may lie that is picked without a surface.
struct PickReach {
    double width = 0; ///< m
    double slope = 0; ///< m more for each m from the ray's origin
};

/// Finds what lies under the mouse on the organ as it is drawn now.
class Picker {
public:
    /// What is drawn is another, or moved: looked at when something is picked.
    void sceneChanged() { m_changed = true; }

    /// The surface's first point on a ray that is not cut away. A model without triangles is picked by its
    /// nodes: the one nearest to the ray for its reach. The scene's mesh and network may be null.
    std::optional<PickedPoint> pick(const RenderScene& scene, const Ray& ray, const PickReach& reach = {});
    /// How far the surface is from a point, m; none without a surface, and where what is nearest is cut away.
    std::optional<double> clearance(const RenderScene& scene, const Eigen::Vector3d& point);
    /// Where the organ as it is drawn now carries a place of its own, m.
    Eigen::Vector3d carried(const RenderScene& scene, const CarriedPlace& place);

private:
    void refresh(const RenderScene& scene);
    std::optional<PickedPoint> pickSurface(const RenderScene& scene, const Ray& ray);
    SurfaceSpot spotOf(const RayHit& hit, const Ray& ray) const;
    Eigen::Vector3d normalOf(const RayHit& hit, const std::vector<Eigen::Vector3d>& vertices) const;
    std::optional<PickedPoint> pickNode(const RenderScene& scene, const Ray& ray,
                                        const PickReach& reach) const;

    std::shared_ptr<const TriangleMesh> m_mesh;
    std::shared_ptr<const SpringNetwork> m_network;
    std::vector<Eigen::Vector3d> m_nodes, m_vertices;
    std::optional<SurfaceQuery> m_query;
    bool m_changed = true; ///< since the last pick
};

} // namespace esm
