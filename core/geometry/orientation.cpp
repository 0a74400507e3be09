#include "core/geometry/orientation.h"

#include "core/geometry/adjacency.h"

#include <algorithm>

namespace esm {

namespace {

/// Triangles that hang together across edges of exactly two triangles.
struct Patch {
    std::vector<std::uint32_t> triangles;
    std::size_t turned = 0;   ///< how many of them run against the first
    double sixfoldVolume = 0; ///< as the first triangle runs
    bool closed = true;
};

struct Neighbour {
    std::uint32_t triangle;
    bool agrees; ///< runs along the shared edge the other way, as it should
};

// Each triangle is reached once from a neighbour, across an edge that only the two share, and turned if it
// runs against it: time linear in the triangles. Edges of more than two are not crossed, since which two of
// their triangles are neighbours is a matter of choice. What cannot agree, a Möbius strip, keeps one line of
// edges where the flood met itself.
//
// Which of the two ways a patch faces is told by the sign of its volume, which any point of reference gives
// alike where the patch is closed. An open one encloses nothing; most of its triangles are then taken to be
// right.
class Orienter {
public:
    Orienter(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Triangle>& triangles)
        : m_vertices(vertices), m_triangles(triangles), m_sides(sidesByEdge(triangles)),
          m_neighbours(triangles.size()), m_patchOf(triangles.size(), noIndex),
          m_turned(triangles.size(), false) {
        findNeighbours();
        for (std::uint32_t i = 0; i < triangles.size(); ++i)
            if (m_patchOf[i] == noIndex) flood(i);
        findOpenPatches();
        for (const Patch& patch : m_patches)
            settle(patch);
    }

    const std::vector<bool>& turned() const { return m_turned; }

private:
    void findNeighbours() {
        forEachEdge(m_sides, [this](auto first, auto last) {
            if (last - first != 2) return;
            const auto second = first + 1;
            const bool agrees = first->forward != second->forward;
            m_neighbours[first->triangle].push_back({second->triangle, agrees});
            m_neighbours[second->triangle].push_back({first->triangle, agrees});
        });
    }

    /// Makes everything that hangs together with a triangle run as it does.
    void flood(std::uint32_t seed) {
        const auto patchIndex = static_cast<std::uint32_t>(m_patches.size());
        Patch patch;
        patch.triangles = {seed};
        m_patchOf[seed] = patchIndex;
        for (std::size_t next = 0; next < patch.triangles.size(); ++next) {
            const std::uint32_t triangle = patch.triangles[next];
            patch.turned += m_turned[triangle];
            for (const Neighbour& neighbour : m_neighbours[triangle]) {
                if (m_patchOf[neighbour.triangle] != noIndex) continue;
                m_patchOf[neighbour.triangle] = patchIndex;
                m_turned[neighbour.triangle] = m_turned[triangle] == neighbour.agrees;
                patch.triangles.push_back(neighbour.triangle);
            }
        }
        const Eigen::Vector3d& origin = m_vertices[m_triangles[seed][0]];
        for (const std::uint32_t triangle : patch.triangles)
            patch.sixfoldVolume +=
                (m_turned[triangle] ? -1 : 1) * sixfoldVolume(m_vertices, m_triangles[triangle], origin);
        m_patches.push_back(std::move(patch));
    }

    /// A patch encloses a volume when along every edge it runs as often one way as the other. That holds for
    /// shells that touch themselves in an edge, too. It does not for Klein's bottle: where it disagrees with
    /// itself, two triangles run the same way.
    void findOpenPatches() {
        forEachEdge(m_sides, [this](auto first, auto last) {
            for (auto side = first; side != last; ++side) {
                int balance = 0;
                for (auto other = first; other != last; ++other)
                    if (m_patchOf[other->triangle] == m_patchOf[side->triangle])
                        balance += other->forward != m_turned[other->triangle] ? 1 : -1;
                if (balance != 0) m_patches[m_patchOf[side->triangle]].closed = false;
            }
        });
    }

    void settle(const Patch& patch) {
        const bool mostRunAgainst = 2 * patch.turned > patch.triangles.size();
        const bool reverse =
            patch.closed && patch.sixfoldVolume != 0 ? patch.sixfoldVolume < 0 : mostRunAgainst;
        if (reverse)
            for (const std::uint32_t triangle : patch.triangles)
                m_turned[triangle] = !m_turned[triangle];
    }

    const std::vector<Eigen::Vector3d>& m_vertices;
    const std::vector<Triangle>& m_triangles;
    std::vector<TriangleSide> m_sides;
    std::vector<std::vector<Neighbour>> m_neighbours;
    std::vector<std::uint32_t> m_patchOf;
    std::vector<bool> m_turned;
    std::vector<Patch> m_patches;
};

} // namespace

std::vector<bool> orientTriangles(const std::vector<Eigen::Vector3d>& vertices,
                                  std::vector<Triangle>& triangles) {
    std::vector<bool> turned = Orienter(vertices, triangles).turned();
    for (std::size_t i = 0; i < triangles.size(); ++i)
        if (turned[i]) std::swap(triangles[i][1], triangles[i][2]);
    return turned;
}

} // namespace esm
