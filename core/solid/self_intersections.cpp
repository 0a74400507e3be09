#include "core/solid/self_intersections.h"

#include "core/support/parallel_steps.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <unsupported/Eigen/BVH>

namespace esm {

namespace {

using Eigen::Vector3d;

using Box = Eigen::AlignedBox3d;
using BoxTree = Eigen::KdBVH<double, 3, std::uint32_t>;

std::vector<Box> boxesOf(const TriangleMesh& mesh) {
    std::vector<Box> boxes(mesh.triangles.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (const std::uint32_t vertex : mesh.triangles[i])
            boxes[i].extend(mesh.vertices[vertex]);
    return boxes;
}

/// Visits the triangles after one of them whose boxes meet its own, as the tree asks.
template<typename Visit> struct BoxMeetings {
    const std::vector<Box>& boxes;
    std::uint32_t one;
    const Visit& visit;

    bool intersectVolume(const Box& box) const { return box.intersects(boxes[one]); }
    bool intersectObject(std::uint32_t other) const {
        if (other > one && boxes[other].intersects(boxes[one])) visit(other);
        return false; // goes on
    }
};

/// Six times the volume of the tetrahedron over a triangle.
double sixfold(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
    return (b - a).cross(c - a).dot(d - a);
}

/// Where a segment pierces the inside of a triangle. What lies within rounding of a corner, an edge or the
/// plane touches and does not pierce.
std::optional<Vector3d> piercing(const Vector3d& from, const Vector3d& to,
                                 const std::array<Vector3d, 3>& triangle) {
    const auto& [a, b, c] = triangle;
    const double above = sixfold(a, b, c, from), below = sixfold(a, b, c, to);
    const double size = std::max({(b - a).norm(), (c - a).norm(), (to - from).norm()});
    const double least = 1e-10 * size * size * size;
    if (std::min(std::abs(above), std::abs(below)) <= least || (above > 0) == (below > 0))
        return std::nullopt;
    const double sides[3] = {sixfold(from, to, a, b), sixfold(from, to, b, c), sixfold(from, to, c, a)};
    const bool isOneWay =
        std::min({sides[0], sides[1], sides[2]}) > least || std::max({sides[0], sides[1], sides[2]}) < -least;
    if (!isOneWay) return std::nullopt;
    return Vector3d(from + (to - from) * (above / (above - below)));
}

/// Where edges of one triangle pierce the other, each in turn until `isEnough(place)`. An edge at a corner of
/// both only touches.
template<typename IsEnough>
void pierce(const TriangleMesh& mesh, std::uint32_t oneNumber, std::uint32_t otherNumber,
            const IsEnough& isEnough) {
    const Triangle &one = mesh.triangles[oneNumber], &other = mesh.triangles[otherNumber];
    const std::array<Vector3d, 3> corners{mesh.vertices[other[0]], mesh.vertices[other[1]],
                                          mesh.vertices[other[2]]};
    const auto isShared = [&](std::uint32_t vertex) {
        return std::find(other.begin(), other.end(), vertex) != other.end();
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t from = one[i], to = one[(i + 1) % 3];
        if (isShared(from) || isShared(to)) continue;
        const auto place = piercing(mesh.vertices[from], mesh.vertices[to], corners);
        if (place && isEnough(*place)) return;
    }
}

std::optional<Vector3d> meeting(const TriangleMesh& mesh, std::uint32_t one, std::uint32_t other) {
    std::optional<Vector3d> first;
    pierce(mesh, one, other, [&](const Vector3d& place) {
        first = place;
        return true;
    });
    return first;
}

} // namespace

// Two triangles that intersect beyond touching have an edge of one through the inside of the other. Only
// those whose boxes meet are tried. A tree of boxes finds them, and not a grid: one triangle that is as long
// as all others are small would lie in all of a grid's cells.
std::vector<MeetingTriangles> meetingTriangles(const TriangleMesh& mesh, const Progress& progress) {
    const std::vector<Box> boxes = boxesOf(mesh);
    std::vector<std::uint32_t> numbers(boxes.size());
    std::iota(numbers.begin(), numbers.end(), 0U);
    const BoxTree tree(numbers.begin(), numbers.end(), boxes.begin(), boxes.end());
    std::vector<std::vector<MeetingTriangles>> met(boxes.size());
    forEachInBlocks(boxes.size(), 512, progress, [&](std::size_t i) {
        const auto one = static_cast<std::uint32_t>(i);
        const auto meet = [&](std::uint32_t other) {
            auto place = meeting(mesh, one, other);
            if (!place) place = meeting(mesh, other, one);
            if (place) met[i].push_back({one, other, *place});
        };
        BoxMeetings<decltype(meet)> meetings{boxes, one, meet};
        Eigen::BVIntersect(tree, meetings);
    });
    reportProgress(progress, 1);
    std::vector<MeetingTriangles> all;
    for (const std::vector<MeetingTriangles>& some : met)
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

std::vector<Vector3d> piercings(const TriangleMesh& mesh, std::uint32_t one, std::uint32_t other) {
    std::vector<Vector3d> places;
    const auto add = [&](const Vector3d& place) {
        places.push_back(place);
        return false;
    };
    pierce(mesh, one, other, add);
    pierce(mesh, other, one, add);
    return places;
}

SelfIntersections selfIntersectionsOf(const TriangleMesh& mesh, const Progress& progress) {
    const std::vector<MeetingTriangles> found = meetingTriangles(mesh, progress);
    if (found.empty()) return {};
    return {found.size(), found.front().place};
}

} // namespace esm
