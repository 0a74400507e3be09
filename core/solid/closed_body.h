#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/surface/surface_query.h"

#include <cstddef>
#include <string>
#include <vector>

namespace esm {

/// One body of an organ: an outer shell, and the shells of its cavities.
struct ClosedBody {
    TriangleMesh surface; ///< the outer shell faces outwards, cavities into themselves: away from the tissue
    std::vector<std::uint32_t> vertices; ///< per vertex of it, its number in the whole surface
    double volume;                       ///< m³, cavities left out
    double area;                         ///< m², cavities too
};

/// The bodies that a closed surface encloses, in the order of their first triangles. A part within a body is
/// a cavity of it, one within a cavity a body of its own, whichever way each faces. Whether the surface runs
/// through itself tells `crossingsOf()`; the volume then counts twice what lies within twice.
/// @throws InvalidModel where the surface is open, has no inside, or encloses nothing
std::vector<ClosedBody> closedBodiesOf(const TriangleMesh& mesh);

/// A ball's radius; of other bodies a measure of how thick they are, m: by volume over area, which needs no
/// directions and tells a plate from a ball of the same width.
double thickness(const ClosedBody& body);

/// A body that is too small for the spacing still gets some three nodes across.
double spacingWithin(const ClosedBody& body, double spacing);

const ClosedBody& largestOf(const std::vector<ClosedBody>& bodies);

/// What can be done where triangles meet: the end of a sentence.
inline constexpr const char* partOrJoinThem =
    "part or join them in a modelling program, or keep the organ hollow, as a wall";

/// "(0.1, 0.2, 0.3) m"
std::string placeText(const Eigen::Vector3d& place);

/// How often a surface winds around a point: 1 within a body, 0 outside (generalised winding number, Jacobson
/// et al. 2013). Every triangle is asked.
double windingNumber(const TriangleMesh& surface, const Eigen::Vector3d& point);

/// Rays against a body's surface, and whether points lie within.
class BodyQuery {
public:
    /// @param body outlives this
    explicit BodyQuery(const ClosedBody& body)
        : m_body(body), m_rays(body.surface.vertices, body.surface.triangles),
          m_size(boundingBox(body.surface.vertices).sizes().maxCoeff()) {}

    bool contains(const Eigen::Vector3d& point) const;
    /// Within 10⁻⁹ of the body's size.
    bool isOn(const Eigen::Vector3d& point) const;
    /// Where the surface is first met from one point towards another, no farther than that.
    std::optional<RayHit> firstBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
    RayHit nearest(const Eigen::Vector3d& point) const { return *m_rays.nearest(point); }
    Eigen::Vector3d placeOf(const RayHit& hit) const;
    /// Of unit length, out of the tissue.
    Eigen::Vector3d normalOf(const RayHit& hit) const;

private:
    const ClosedBody& m_body;
    SurfaceQuery m_rays;
    double m_size; ///< m
};

} // namespace esm
