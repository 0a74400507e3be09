#pragma once

#include "core/texture/atlas/group_layout.h"

#include <limits>

namespace esm {

/// Lays out a surface in unfolded groups, at one scale after another. Groups whose triangles keep the gap at
/// one scale keep it at all larger ones, so they are unfolded anew only for a smaller scale.
class UnfoldedGroups {
public:
    /// @param shapes of all triangles, in the mesh's order; both must outlive this
    UnfoldedGroups(const TriangleMesh& mesh, const std::vector<PatchShape>& shapes)
        : m_mesh(mesh), m_shapes(shapes) {}

    PatchLayout layoutAt(double texelsPerMetre, const PageRoom& page, int mostPages,
                         const Progress& progress);
    /// Of the latest layout, in its order: triangles as they were given, whose first corner comes first.
    const std::vector<PatchShape>& order() const { return m_order; }

private:
    void unfoldFor(double texelsPerMetre, double gap, const Progress& progress);

    const TriangleMesh& m_mesh;
    const std::vector<PatchShape>& m_shapes;
    double m_smallestScale = std::numeric_limits<double>::infinity();
    std::vector<TurnedGroup> m_groups; ///< tallest first
    std::vector<PatchShape> m_order;
};

} // namespace esm
