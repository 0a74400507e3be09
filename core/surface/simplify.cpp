#include "core/surface/simplify.h"

#include "core/geometry/adjacency.h"
#include "core/support/errors.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <map>
#include <string>

namespace esm {

namespace {

using Indices = std::vector<std::uint32_t>; ///< three per triangle

constexpr float anyError = 1e6F;  // of the extent: the count alone says where to stop
constexpr int mostAttempts = 8;   // each simplifies the whole surface
constexpr double roughness = 0.1; ///< of the edges' length

/// From −1 to 1, the same for a number on every machine: Wang's hash of 32 bits, whose 2³² values the last
/// line spreads over the range. Neighbouring numbers give unlike values, as vertices that are numbered in
/// rows need; anything smoother would lay waves over the surface.
double noise(std::uint32_t number) {
    number = (number ^ 61U ^ (number >> 16U)) * 9U;
    number = (number ^ (number >> 4U)) * 0x27d4eb2dU;
    number ^= number >> 15U;
    return number / 2147483647.5 - 1;
}

/// Mean length of the edges at each vertex. Roughness is measured by it, so that fine and coarse parts of a
/// mesh are alike rough.
std::vector<double> meanEdges(const TriangleMesh& mesh) {
    std::vector<double> sums(mesh.vertices.size(), 0), counts(mesh.vertices.size(), 0);
    for (const Edge& edge : uniqueEdges(mesh.triangles))
        for (const std::uint32_t end : {edge.first, edge.second}) {
            sums[end] += (mesh.vertices[edge.first] - mesh.vertices[edge.second]).norm();
            ++counts[end];
        }
    for (std::size_t i = 0; i < sums.size(); ++i)
        if (counts[i] > 0) sums[i] /= counts[i];
    return sums;
}

/// In single precision about the middle, so that no place in space costs accuracy. A little rough: on a
/// smooth surface the library leaves vertices only where it bends, and tissue bends anywhere. A tenth of an
/// edge is small beside the edges that are left. The roughness decides only which vertices stay; where these
/// lie is not changed.
std::vector<float> roughCoordinates(const TriangleMesh& mesh) {
    const Eigen::Vector3d centre = boundingBox(mesh.vertices).center();
    const std::vector<Eigen::Vector3d> normals = vertexNormals(mesh.vertices, mesh.triangles);
    const std::vector<double> edges = meanEdges(mesh);
    std::vector<float> coordinates;
    coordinates.reserve(3 * mesh.vertices.size());
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
        const Eigen::Vector3d lifted =
            mesh.vertices[i] - centre + roughness * noise(i) * edges[i] * normals[i];
        for (const double coordinate : lifted)
            coordinates.push_back(static_cast<float>(coordinate));
    }
    return coordinates;
}

Indices cornerIndices(const std::vector<Triangle>& triangles) {
    Indices indices;
    indices.reserve(3 * triangles.size());
    for (const Triangle& triangle : triangles)
        indices.insert(indices.end(), triangle.begin(), triangle.end());
    return indices;
}

double squaredArea(const TriangleMesh& mesh, const Triangle& triangle) {
    const Eigen::Vector3d& a = mesh.vertices[triangle[0]];
    return (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a).squaredNorm();
}

/// Corner indices with the lowest first, in the same direction.
Triangle fromTheLowest(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return a < b && a < c ? Triangle{a, b, c} : b < c ? Triangle{b, c, a} : Triangle{c, a, b};
}

/// The library folds some tips flat: two triangles of the same corners that face each other enclose nothing,
/// and both go. Where three lie on the same corners, one of them is left.
Indices withoutFolds(const Indices& indices) {
    std::map<Triangle, std::size_t> faces;
    std::vector<bool> isFolded(indices.size() / 3, false);
    for (std::size_t i = 0; i < isFolded.size(); ++i) {
        const std::uint32_t a = indices[3 * i], b = indices[3 * i + 1], c = indices[3 * i + 2];
        const auto opposite = faces.find(fromTheLowest(a, c, b));
        if (opposite == faces.end()) {
            faces.emplace(fromTheLowest(a, b, c), i);
            continue;
        }
        isFolded[i] = isFolded[opposite->second] = true;
        faces.erase(opposite);
    }
    Indices result;
    for (std::size_t i = 0; i < isFolded.size(); ++i)
        if (!isFolded[i]) result.insert(result.end(), &indices[3 * i], &indices[3 * i] + 3);
    return result;
}

/// Finds the number of triangles, which the library counts, that leaves the number of vertices asked for. The
/// surface is coarsened by collapsing edges, the one first whose new vertex is the least off the planes of
/// all triangles that went into it (quadric error metrics, Garland and Heckbert 1997). Vertices are left out
/// but never moved: nodes are then vertices of the drawn mesh, which hang on themselves alone. Meshing the
/// surface anew would give more even triangles, but nodes that no drawn vertex belongs to.
class Simplification {
public:
    Simplification(const TriangleMesh& mesh, std::size_t wanted, const Progress& progress)
        : m_mesh(mesh), m_wanted(wanted), m_coordinates(roughCoordinates(mesh)),
          m_whole(cornerIndices(mesh.triangles)), m_parts(progress) {}

    Indices run() { return withEveryPart(trimmed(fromTheWhole())); }

private:
    Indices reduced(const Indices& from, std::size_t triangles) {
        reportProgress(m_parts.nextOfRest(0.25), 0);
        Indices result(from.size());
        result.resize(meshopt_simplify(result.data(), from.data(), from.size(), m_coordinates.data(),
                                       m_mesh.vertices.size(), 3 * sizeof(float), 3 * triangles, anyError, 0,
                                       nullptr));
        return withoutFolds(result);
    }

    std::size_t verticesOf(const Indices& indices) const {
        std::vector<bool> used(m_mesh.vertices.size(), false);
        for (const std::uint32_t vertex : indices)
            used[vertex] = true;
        return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
    }

    /// The coarsest found that has no fewer vertices than wanted. Errors are those to the whole surface:
    /// always from the whole, as what is coarsened twice is compared with what was left the first time.
    ///
    /// Vertices grow nearly in proportion to triangles. A false position, on the line between the last number
    /// of triangles that left too many vertices and the last that left too few, therefore comes near soon;
    /// what is still too many is trimmed.
    Indices fromTheWhole() {
        Indices best = m_whole;
        std::size_t bestVertices = verticesOf(best), tooFew = 0, tooFewVertices = 0;
        if (bestVertices <= m_wanted) return best;
        // A closed surface loses two triangles with each vertex.
        std::size_t target = lessBy(best.size() / 3, 2 * (bestVertices - m_wanted));
        for (int attempt = 0; attempt < mostAttempts && bestVertices > m_wanted; ++attempt) {
            Indices result = reduced(m_whole, target);
            const std::size_t vertices = verticesOf(result), triangles = result.size() / 3;
            if (vertices < m_wanted) {
                tooFew = std::max(tooFew, target);
                tooFewVertices = vertices;
            } else if (vertices < bestVertices) {
                best = std::move(result);
                bestVertices = vertices;
            }
            if (vertices >= m_wanted && triangles > target) break; // the library can do no more
            const std::size_t most = best.size() / 3;
            if (most <= tooFew + 1) break;
            const double share = static_cast<double>(m_wanted - tooFewVertices) /
                                 static_cast<double>(bestVertices - tooFewVertices);
            target = std::clamp(tooFew + static_cast<std::size_t>(share * static_cast<double>(most - tooFew)),
                                tooFew + 1, most - 1);
        }
        return best;
    }

    /// Takes away the few that are too many, never more: no vertex takes less than one triangle with it.
    Indices trimmed(Indices indices) {
        for (std::size_t step = lessBy(verticesOf(indices), m_wanted); step > 0;) {
            Indices fewer = reduced(indices, lessBy(indices.size() / 3, step));
            const std::size_t vertices = verticesOf(fewer);
            if (vertices >= m_wanted && fewer.size() < indices.size()) {
                indices = std::move(fewer);
                step = vertices - m_wanted;
            } else {
                step /= 2;
            }
        }
        return indices;
    }

    /// A part that vanished keeps its largest triangle. Its drawn vertices must hang on nodes of their own
    /// part: those of another would drag them through the gap between both.
    Indices withEveryPart(Indices indices) const {
        const Parts parts = connectedParts(m_mesh.triangles, m_mesh.vertices.size());
        std::vector<std::uint32_t> partOfVertex(m_mesh.vertices.size(), noIndex);
        std::vector<std::uint32_t> largest(parts.count, noIndex);
        for (std::uint32_t i = 0; i < m_mesh.triangles.size(); ++i) {
            std::uint32_t& best = largest[parts.ofTriangle[i]];
            const Triangle& triangle = m_mesh.triangles[i];
            if (best == noIndex ||
                squaredArea(m_mesh, triangle) > squaredArea(m_mesh, m_mesh.triangles[best]))
                best = i;
            for (const std::uint32_t vertex : triangle)
                partOfVertex[vertex] = parts.ofTriangle[i];
        }
        for (std::size_t i = 0; i < indices.size(); i += 3)
            largest[partOfVertex[indices[i]]] = noIndex;
        for (const std::uint32_t triangle : largest)
            if (triangle != noIndex)
                indices.insert(indices.end(), m_mesh.triangles[triangle].begin(),
                               m_mesh.triangles[triangle].end());
        return indices;
    }

    static std::size_t lessBy(std::size_t count, std::size_t removed) {
        return count > removed ? count - removed : 0;
    }

    const TriangleMesh& m_mesh;
    std::size_t m_wanted;
    std::vector<float> m_coordinates;
    Indices m_whole;
    ProgressParts m_parts;
};

/// Numbers the vertices that are used anew, in their order.
SimplifiedMesh renumbered(const Indices& indices, std::size_t vertexCount) {
    std::vector<std::uint32_t> places(vertexCount, noIndex);
    for (const std::uint32_t vertex : indices)
        places[vertex] = 0;
    SimplifiedMesh mesh;
    for (std::uint32_t vertex = 0; vertex < vertexCount; ++vertex)
        if (places[vertex] != noIndex) {
            places[vertex] = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.push_back(vertex);
        }
    for (std::size_t i = 0; i < indices.size(); i += 3)
        mesh.triangles.push_back({places[indices[i]], places[indices[i + 1]], places[indices[i + 2]]});
    return mesh;
}

} // namespace

SimplifiedMesh simplify(const TriangleMesh& mesh, std::size_t vertexCount, const Progress& progress) {
    const std::size_t most = mesh.vertices.size();
    if (vertexCount < fewestVertices || vertexCount > most)
        throw InvalidModel("the surface has " + std::to_string(most) + " vertices and can be simulated by " +
                           std::to_string(fewestVertices) + " to " + std::to_string(most) +
                           " nodes, not by " + std::to_string(vertexCount));
    SimplifiedMesh simplified = renumbered(Simplification(mesh, vertexCount, progress).run(), most);
    reportProgress(progress, 1);
    return simplified;
}

} // namespace esm
