#include "widgets/view/picking.h"

#include "core/render/drawn_shape.h"

namespace esm {

Eigen::Vector3d pointOf(const CarriedPlace& place, const std::vector<Eigen::Vector3d>& positions) {
    const auto& [a, b, c] = place.corners;
    return place.weights[0] * positions[a] + place.weights[1] * positions[b] +
           place.weights[2] * positions[c];
}

std::optional<PickedPoint> Picker::pick(const RenderScene& scene, const Ray& ray, const PickReach& reach) {
    if (m_changed) refresh(scene);
    return m_query ? pickSurface(scene, ray) : pickNode(scene, ray, reach);
}

std::optional<double> Picker::clearance(const RenderScene& scene, const Eigen::Vector3d& point) {
    if (m_changed) refresh(scene);
    const std::optional<RayHit> nearest = m_query ? m_query->nearest(point) : std::nullopt;
    if (!nearest) return std::nullopt;
    const Eigen::Vector3d place =
        pointOf({m_mesh->triangles[nearest->triangle], nearest->barycentric}, m_vertices);
    return scene.cut && scene.cut->hides(place) ? std::nullopt : std::optional(nearest->distance);
}

Eigen::Vector3d Picker::carried(const RenderScene& scene, const CarriedPlace& place) {
    if (m_changed) refresh(scene);
    return pointOf(place, m_query ? m_vertices : m_nodes);
}

/// While tissue moves only places change: the tree of rays is refitted, which is far cheaper than building
/// it, as long as the triangles are the same. Nothing is done before someone picks.
void Picker::refresh(const RenderScene& scene) {
    const bool other = scene.mesh != m_mesh || scene.network != m_network;
    m_mesh = scene.mesh;
    m_network = scene.network;
    m_nodes = drawnNodes(scene);
    m_vertices = drawnVertices(scene, m_nodes);
    m_changed = false;
    if (!m_mesh || m_mesh->triangles.empty())
        m_query.reset();
    else if (other || !m_query)
        m_query.emplace(m_vertices, m_mesh->triangles);
    else
        m_query->refit(m_vertices);
}

std::optional<PickedPoint> Picker::pickSurface(const RenderScene& scene, const Ray& whole) {
    const std::optional<RayPart> left = leftBy(scene.cut, whole);
    if (!left) return std::nullopt;
    const Ray& ray = left->ray;
    const std::optional<RayHit> hit = m_query->firstHit(ray);
    if (!hit || hit->distance > left->length) return std::nullopt;
    Eigen::Index nearest = 0;
    hit->barycentric.maxCoeff(&nearest);
    const std::uint32_t vertex = m_mesh->triangles[hit->triangle][static_cast<std::size_t>(nearest)];
    const std::uint32_t node = m_network ? m_network->vertexNodes[vertex] : vertex;
    return PickedPoint{node,
                       ray.origin + hit->distance * ray.direction.normalized(),
                       m_nodes[node],
                       spotOf(*hit, ray),
                       normalOf(*hit, m_mesh->vertices).stableNormalized(),
                       CarriedPlace{m_mesh->triangles[hit->triangle], hit->barycentric}};
}

Eigen::Vector3d Picker::normalOf(const RayHit& hit, const std::vector<Eigen::Vector3d>& vertices) const {
    const auto& [a, b, c] = m_mesh->triangles[hit.triangle];
    return (vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]);
}

/// On the organ at rest: photos and strokes lie there and go along as it moves. The normal is turned to the
/// side that is looked at, also inside an open organ.
SurfaceSpot Picker::spotOf(const RayHit& hit, const Ray& ray) const {
    const double side = normalOf(hit, m_vertices).dot(ray.direction) > 0 ? -1 : 1;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    for (Eigen::Index corner = 0; corner < 3; ++corner)
        point += hit.barycentric[corner] *
                 m_mesh->vertices[m_mesh->triangles[hit.triangle][static_cast<std::size_t>(corner)]];
    return {point, side * normalOf(hit, m_mesh->vertices).stableNormalized()};
}

/// Bare springs have no surface. The node is taken that lies nearest to the ray for its reach there; what
/// lies behind the ray's origin is out of reach.
std::optional<PickedPoint> Picker::pickNode(const RenderScene& scene, const Ray& ray,
                                            const PickReach& reach) const {
    const Eigen::Vector3d direction = ray.direction.normalized();
    double smallest = 1;
    const auto& rest = m_network ? m_network->restPositions : m_mesh->vertices;
    std::optional<PickedPoint> picked;
    for (std::uint32_t node = 0; node < m_nodes.size(); ++node) {
        const Eigen::Vector3d offset = m_nodes[node] - ray.origin;
        const double depth = offset.dot(direction);
        const double aside = offset.cross(direction).norm() / (reach.width + reach.slope * depth);
        if (depth < 0 || !(aside <= smallest) || (scene.cut && scene.cut->hides(m_nodes[node]))) continue;
        smallest = aside;
        picked = PickedPoint{node,
                             m_nodes[node],
                             m_nodes[node],
                             SurfaceSpot{rest[node], -direction},
                             Eigen::Vector3d::Zero(),
                             CarriedPlace{{node, node, node}, Eigen::Vector3d::UnitX()}};
    }
    return picked;
}

} // namespace esm
