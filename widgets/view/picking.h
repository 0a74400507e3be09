#pragma once

#include "core/geometry/surface_query.h"
#include "core/render/renderer.h"

#include <memory>
#include <optional>
#include <vector>

namespace esm {

struct PickedPoint {
    std::uint32_t node;           ///< nearest to the point
    Eigen::Vector3d point;        ///< m
    Eigen::Vector3d nodePosition; ///< m
};

/// Finds what lies under the mouse on the organ as it is drawn now.
class Picker {
public:
    /// The scene's mesh and network; both may be null.
    void setScene(const RenderScene& scene);

    /// The surface's first point on a ray. A model without triangles is picked by its nodes: the one nearest
    /// to the ray, seen from the ray's origin under at most `tolerance` (rad).
    std::optional<PickedPoint> pick(const Ray& ray, double tolerance);

private:
    void refresh();
    std::optional<PickedPoint> pickSurface(const Ray& ray);
    std::optional<PickedPoint> pickNode(const Ray& ray, double tolerance) const;

    std::shared_ptr<const TriangleMesh> m_mesh;
    std::shared_ptr<const SpringNetwork> m_network;
    std::vector<Eigen::Vector3d> m_nodes, m_vertices;
    std::optional<SurfaceQuery> m_query;
    bool m_moved = false; ///< since the query was fitted
};

} // namespace esm
