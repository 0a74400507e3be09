#include "core/texture/layers/outline_feather.h"

#include "core/geometry/segment_distance.h"
#include "core/support/parallel_steps.h"
#include "core/support/smooth_step.h"
#include "core/texture/layers/photo_ray.h"

#include <algorithm>
#include <cmath>
#include <tbb/enumerable_thread_specific.h>

namespace esm {

namespace {

constexpr double besideOutline = 0.25; ///< photo pixels beyond an outline at which rays look what lies behind
constexpr std::size_t outlinesPerBlock = 64;

/// A side of triangles beyond which the surface is not seen to go on: it turns away there, or ends.
struct OutlineEdge {
    std::array<std::uint32_t, 2> ends; ///< vertices
    bool isLeft;   ///< the surface lies on the left from the first to the second, as the photo shows it
    bool isBorder; ///< the surface ends
};

/// A straight part of an outline in the photo.
struct OutlinePiece {
    Eigen::Vector2d start, end; ///< pixels
    double strength;            ///< 0 to 1, by how far behind it the next surface lies
};

/// Vertices as `photoMatrix` gives them.
using SeenVertices = std::vector<Eigen::Vector4d>;

Eigen::Vector3d inPhoto(const Eigen::Vector4d& seen) {
    return seen.head<3>();
}

/// Three points in the form (x·w, y·w, w) run around clockwise in the photo, y being down, where their
/// determinant is above 0; so it does for a triangle of which a corner lies behind the eye.
bool runsClockwise(const SeenVertices& seen, const Triangle& triangle) {
    Eigen::Matrix3d corners;
    for (std::size_t i = 0; i < 3; ++i)
        corners.col(static_cast<Eigen::Index>(i)) = inPhoto(seen[triangle[i]]);
    return corners.determinant() > 0;
}

/// Where of two triangles at an edge one is seen from its front and the other from its back. Only from these
/// edges on can something else be seen, whatever the surface does between them.
std::vector<OutlineEdge> outlineEdges(const ShadowCaster& surface, const SeenVertices& seen) {
    const std::vector<Triangle>& triangles = surface.mesh.triangles;
    std::vector<std::uint8_t> clockwise(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
        clockwise[i] = runsClockwise(seen, triangles[i]) ? 1 : 0;
    std::vector<OutlineEdge> edges;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t side = 0; side < 3; ++side) {
            const std::uint32_t across = surface.across[i][side];
            const bool isBorder = across == noIndex;
            if (!isBorder && (across < i || clockwise[across] == clockwise[i])) continue;
            edges.push_back(
                {{triangles[i][side], triangles[i][(side + 1) % 3]}, clockwise[i] == 0, isBorder});
        }
    return edges;
}

/// The part of an edge, in the form of `SeenVertices`, where `boundary` · end ≥ 0; nothing where there is
/// none.
bool cut(std::array<Eigen::Vector4d, 2>& edge, const Eigen::Vector3d& boundary) {
    const double first = boundary.dot(inPhoto(edge[0])), second = boundary.dot(inPhoto(edge[1]));
    if (first < 0 && second < 0) return false;
    const Eigen::Vector4d on = edge[0] + first / (first - second) * (edge[1] - edge[0]);
    if (first < 0) edge[0] = on;
    if (second < 0) edge[1] = on;
    return edge[0].allFinite() && edge[1].allFinite();
}

/// Finds the outlines that the projector sees, and how strong they are.
///
/// What is hidden begins, anywhere on the surface, behind an outline in the photo. So a weight that falls to
/// 0 towards the outlines, measured in the photo, is without a step all over the surface, however coarse its
/// triangles are. Distances are taken to the edges themselves instead of to steps in a depth picture, whose
/// pixels would show.
class OutlineFinder {
public:
    OutlineFinder(const ShadowCaster& surface, const SurfaceQuery& query, const Projector& projector,
                  PhotoSize photo, double blendPixels)
        : m_surface(surface), m_query(query), m_projector(projector), m_photo(photo), m_margin(blendPixels),
          m_pieceLength(std::max(1.0, 2 * nodeSpacing(blendPixels))) {
        const Eigen::Matrix4d matrix = photoMatrix(projector, photo);
        m_seen.reserve(surface.mesh.vertices.size());
        for (const Eigen::Vector3d& vertex : surface.mesh.vertices)
            m_seen.emplace_back(matrix * vertex.homogeneous());
    }

    std::vector<OutlinePiece> pieces(const Progress& progress) const {
        const std::vector<OutlineEdge> edges = outlineEdges(m_surface, m_seen);
        tbb::enumerable_thread_specific<std::vector<OutlinePiece>> found;
        forEachInBlocks(edges.size(), outlinesPerBlock, progress,
                        [&](std::size_t i) { addPieces(edges[i], found.local()); });
        std::vector<OutlinePiece> all;
        for (const std::vector<OutlinePiece>& some : found)
            all.insert(all.end(), some.begin(), some.end());
        return all;
    }

private:
    /// Of the part near the photo, pieces so short that they are seen as a whole or not at all. Fractions of
    /// an edge in the photo are not those in space: f there is t = f·w₀ / (w₁ + f (w₀ − w₁)) here.
    void addPieces(const OutlineEdge& edge, std::vector<OutlinePiece>& pieces) const {
        std::array<Eigen::Vector4d, 2> part{m_seen[edge.ends[0]], m_seen[edge.ends[1]]};
        if (!isNearPhoto(part)) return;
        const double first = part[0].z(), second = part[1].z();
        const Eigen::Vector2d start = part[0].head<2>() / first, way = part[1].head<2>() / second - start;
        if (!(way.norm() > 0) || !way.allFinite()) return;
        const Eigen::Vector2d left = Eigen::Vector2d(way.y(), -way.x()).normalized();
        const Eigen::Vector2d outward = edge.isLeft ? -left : left;
        const auto count = static_cast<int>(std::ceil(way.norm() / m_pieceLength));
        for (int i = 0; i < count; ++i) {
            const double middle = (i + 0.5) / count;
            const double inSpace = middle * first / (second + middle * (first - second));
            const double depth = part[0].w() + inSpace * (part[1].w() - part[0].w());
            if (!(depth > 0)) continue;
            const double strength =
                strengthAt(start + middle * way + besideOutline * outward, depth, edge.isBorder);
            if (strength > 0)
                pieces.push_back({start + i * way / count, start + (i + 1) * way / count, strength});
        }
    }

    bool isNearPhoto(std::array<Eigen::Vector4d, 2>& edge) const {
        const Eigen::Vector3d forward = Eigen::Vector3d::UnitZ();
        const Eigen::Vector2d size(m_photo.width, m_photo.height);
        for (int axis = 0; axis < 2; ++axis) {
            const Eigen::Vector3d along = Eigen::Vector3d::Unit(axis);
            if (!cut(edge, along + m_margin * forward)) return false;
            if (!cut(edge, (size[axis] + m_margin) * forward - along)) return false;
        }
        return edge[0].z() > 0 && edge[1].z() > 0 && std::max(edge[0].w(), edge[1].w()) > 0;
    }

    /// What a ray just beside the outline meets says both whether the outline is seen and what is seen beside
    /// it. Nothing ends at a border with nothing behind: no surface there has a step.
    double strengthAt(const Eigen::Vector2d& beside, double depth, bool isBorder) const {
        Ray ray = rayThrough(m_projector, m_photo, beside);
        const double perDepth = ray.direction.norm();
        const auto hit = m_query.firstHit(ray);
        if (!hit) return isBorder ? 0 : 1;
        return hiddenShare(hit->distance / perDepth - depth, m_surface.tolerance);
    }

    const ShadowCaster& m_surface;
    const SurfaceQuery& m_query;
    const Projector& m_projector;
    PhotoSize m_photo;
    double m_margin, m_pieceLength; ///< pixels
    SeenVertices m_seen;
};

/// Lets all nodes near the piece fade by it.
void fade(PhotoFade& feather, const OutlinePiece& piece, double blendPixels) {
    const auto node = [&](double pixels, int count) {
        return static_cast<int>(std::clamp(pixels / feather.spacing, 0.0, count - 1.0));
    };
    const Eigen::Vector2d low = piece.start.cwiseMin(piece.end).array() - blendPixels;
    const Eigen::Vector2d high = piece.start.cwiseMax(piece.end).array() + blendPixels + feather.spacing;
    for (int row = node(low.y(), feather.rows); row <= node(high.y(), feather.rows); ++row)
        for (int column = node(low.x(), feather.columns); column <= node(high.x(), feather.columns);
             ++column) {
            const Eigen::Vector2d place = feather.spacing * Eigen::Vector2d(column, row);
            const double distance = distanceToSegment(place, piece.start, piece.end);
            if (distance >= blendPixels) continue;
            const double left = smoothStep(0, blendPixels, distance);
            float& faded =
                feather.faded[static_cast<std::size_t>(row) * static_cast<std::size_t>(feather.columns) +
                              static_cast<std::size_t>(column)];
            faded = std::max(faded, static_cast<float>(piece.strength * (1 - left)));
        }
}

} // namespace

/// Each piece of an outline fades the nodes within its reach, and the greatest fading counts, so that the
/// order of the pieces does not.
PhotoFade outlineFeather(const ShadowCaster& surface, const SurfaceQuery& query, const Projector& projector,
                         PhotoSize photo, double blendPixels, const Progress& progress) {
    if (!(blendPixels > 0)) return {};
    ProgressParts parts(progress);
    const OutlineFinder finder(surface, query, projector, photo, blendPixels);
    const std::vector<OutlinePiece> pieces = finder.pieces(parts.next(0.7));
    if (pieces.empty()) return {};
    PhotoFade feather = unfaded(photo, blendPixels);
    const Progress fading = parts.rest();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        reportStep(fading, i, pieces.size());
        fade(feather, pieces[i], blendPixels);
    }
    return feather;
}

} // namespace esm
