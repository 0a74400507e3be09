#include "core/solid/closed_body.h"

#include "core/geometry/adjacency.h"
#include "core/geometry/open_borders.h"
#include "core/solid/self_intersections.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Eigen::Vector3d;

void refuseOpen(const TriangleMesh& mesh, const EdgeCounts& edges) {
    if (edges.boundary > 0) {
        const std::vector<OpenBorder> borders = openBordersOf(mesh);
        std::string message =
            "the surface is open and has no inside to fill: " + std::to_string(edges.boundary) +
            " open edges";
        if (!borders.empty())
            message += " in " + std::to_string(borders.size()) + " borders, the longest of " +
                       std::to_string(borders.front().loop.size()) + " edges";
        throw InvalidModel(message +
                           "; close slits and fill holes at import, or give the organ a wall of prisms, "
                           "which may be open");
    }
    if (edges.inconsistent > 0)
        throw InvalidModel(
            "the surface has no inside: at " + std::to_string(edges.inconsistent) +
            " edges it turns its inside out; repair it in a modelling program, or keep the organ "
            "hollow, as a wall");
}

void refuseIntersecting(const TriangleMesh& mesh) {
    const SelfIntersections found = selfIntersectionsOf(mesh);
    if (found.pairs > 0)
        throw InvalidModel("the surface runs through itself: " + std::to_string(found.pairs) +
                           " pairs of triangles meet, the first at " + placeText(found.first) + "; " +
                           partOrJoinThem);
}

/// A connected part of the surface, facing outwards by itself.
struct SurfaceShell {
    TriangleMesh surface;
    std::vector<std::uint32_t> vertices; ///< their numbers in the whole surface
    Eigen::AlignedBox3d box;
    Vector3d point; ///< one of its own
    double volume = 0;
};

// Vertices are numbered anew within each shell, so that its box and its rays do not reach over to others.
std::vector<SurfaceShell> shellsOf(const TriangleMesh& mesh) {
    const Parts parts = connectedParts(mesh.triangles, mesh.vertices.size());
    std::vector<SurfaceShell> shells(parts.count);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        shells[parts.ofTriangle[i]].surface.triangles.push_back(mesh.triangles[i]);
    std::vector<std::uint32_t> numbers(mesh.vertices.size(), noIndex);
    for (SurfaceShell& shell : shells) {
        for (Triangle& triangle : shell.surface.triangles)
            for (std::uint32_t& vertex : triangle) {
                if (numbers[vertex] == noIndex) {
                    numbers[vertex] = static_cast<std::uint32_t>(shell.surface.vertices.size());
                    shell.surface.vertices.push_back(mesh.vertices[vertex]);
                    shell.vertices.push_back(vertex);
                }
                vertex = numbers[vertex];
            }
        shell.box = boundingBox(shell.surface.vertices);
        shell.point = shell.surface.vertices.front();
        shell.volume = enclosedVolume(shell.surface);
    }
    return shells;
}

void turn(TriangleMesh& surface) {
    for (Triangle& triangle : surface.triangles)
        std::swap(triangle[1], triangle[2]);
}

/// For each shell those that it lies within.
std::vector<std::vector<std::size_t>> shellsAround(const std::vector<SurfaceShell>& shells) {
    std::vector<std::vector<std::size_t>> around(shells.size());
    for (std::size_t i = 0; i < shells.size(); ++i)
        for (std::size_t j = 0; j < shells.size(); ++j)
            if (i != j && shells[j].box.contains(shells[i].box) &&
                std::abs(windingNumber(shells[j].surface, shells[i].point)) > 0.5)
                around[i].push_back(j);
    return around;
}

// Repair lets every closed part face outwards, cavities too. Here each faces away from the tissue, so that
// the volumes of all shells of a body add up to its own.
void append(ClosedBody& body, SurfaceShell shell, bool isCavity) {
    const double volume = std::abs(shell.volume);
    if ((shell.volume < 0) != isCavity) turn(shell.surface);
    const auto first = static_cast<std::uint32_t>(body.surface.vertices.size());
    body.area += surfaceArea(shell.surface);
    body.volume += isCavity ? -volume : volume;
    body.surface.vertices.insert(body.surface.vertices.end(), shell.surface.vertices.begin(),
                                 shell.surface.vertices.end());
    body.vertices.insert(body.vertices.end(), shell.vertices.begin(), shell.vertices.end());
    for (const Triangle& triangle : shell.surface.triangles)
        body.surface.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
}

} // namespace

std::string placeText(const Vector3d& place) {
    return "(" + roundedText(place.x(), 4) + ", " + roundedText(place.y(), 4) + ", " +
           roundedText(place.z(), 4) + ") m";
}

// Each shell lies in another whole or not at all, and one point tells; where they run through each other,
// what lies beyond is narrow or will be refused. Within an even number of others a shell has tissue inside;
// within an odd number it is the wall of a cavity, of the one around it that lies within one fewer.
std::vector<ClosedBody> closedBodiesOf(const TriangleMesh& mesh) {
    refuseOpen(mesh, countEdges(sidesByEdge(mesh.triangles)));
    std::vector<SurfaceShell> shells = shellsOf(mesh);
    const auto around = shellsAround(shells);
    std::vector<ClosedBody> bodies;
    std::vector<std::size_t> bodyOf(shells.size());
    for (std::size_t i = 0; i < shells.size(); ++i)
        if (around[i].size() % 2 == 0) {
            bodyOf[i] = bodies.size();
            append(bodies.emplace_back(ClosedBody{{}, {}, 0, 0}), shells[i], false);
        }
    for (std::size_t i = 0; i < shells.size(); ++i) {
        if (around[i].size() % 2 == 0) continue;
        const auto outer = std::find_if(around[i].begin(), around[i].end(), [&](std::size_t shell) {
            return around[shell].size() + 1 == around[i].size();
        });
        if (outer == around[i].end()) refuseIntersecting(mesh);
        append(bodies[bodyOf[*outer]], shells[i], true);
    }
    for (const ClosedBody& body : bodies)
        if (!(body.volume > 1e-9 * std::pow(body.area, 1.5))) {
            refuseIntersecting(mesh);
            throw InvalidModel("a part of the surface encloses nothing that could be filled, near " +
                               placeText(body.surface.vertices.front()) + "; leave it out at import");
        }
    if (bodies.empty()) throw InvalidModel("there is no surface to fill");
    return bodies;
}

// The solid angle of each triangle (van Oosterom and Strackee 1983), all of them, over that of the sphere.
double windingNumber(const TriangleMesh& surface, const Vector3d& point) {
    double angle = 0;
    for (const Triangle& triangle : surface.triangles) {
        const Vector3d a = surface.vertices[triangle[0]] - point, b = surface.vertices[triangle[1]] - point,
                       c = surface.vertices[triangle[2]] - point;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        angle +=
            2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return angle / (4 * M_PI);
}

double thickness(const ClosedBody& body) {
    return 3 * body.volume / body.area;
}

double spacingWithin(const ClosedBody& body, double spacing) {
    return std::min(spacing, thickness(body) / 1.5);
}

const ClosedBody& largestOf(const std::vector<ClosedBody>& bodies) {
    return *std::max_element(bodies.begin(), bodies.end(),
                             [](const auto& one, const auto& other) { return one.volume < other.volume; });
}

// Who looks at the surface from within sees its back. One ray in a thousand grazes an edge and may be told
// the wrong side; two rays that lie in no plane of a lattice seldom err both, and where they disagree every
// triangle is asked. What lies on the surface itself counts as within.
bool BodyQuery::contains(const Vector3d& point) const {
    const auto seesBack = [&](const Vector3d& direction) {
        const auto hit = m_rays.firstHit({point, direction});
        return hit && direction.dot(normalOf(*hit)) > 0;
    };
    const bool one = seesBack({0.8117, 0.5123, 0.2806}), other = seesBack({-0.3361, 0.6577, -0.6742});
    if (one == other) return one;
    return isOn(point) || windingNumber(m_body.surface, point) > 0.5;
}

bool BodyQuery::isOn(const Vector3d& point) const {
    return nearest(point).distance <= 1e-9 * m_size;
}

std::optional<RayHit> BodyQuery::firstBetween(const Vector3d& from, const Vector3d& to) const {
    const auto hit = m_rays.firstHit({from, to - from});
    return hit && hit->distance <= (to - from).norm() ? hit : std::nullopt;
}

Vector3d BodyQuery::placeOf(const RayHit& hit) const {
    const Triangle& triangle = m_body.surface.triangles[hit.triangle];
    Vector3d place = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
        place += hit.barycentric[i] * m_body.surface.vertices[triangle[static_cast<std::size_t>(i)]];
    return place;
}

Vector3d BodyQuery::normalOf(const RayHit& hit) const {
    return areaNormal(m_body.surface.vertices, m_body.surface.triangles[hit.triangle]).normalized();
}

} // namespace esm
