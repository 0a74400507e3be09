#pragma once

#include "core/texture/atlas/charts/flattening.h"
#include "core/texture/atlas/charts/segmentation.h"
#include "core/texture/atlas/group_layout.h"
#include "core/texture/atlas/stretch.h"

namespace esm {

/// How much a chart may be distorted; two smaller ones take the place of one that is distorted more.
constexpr DistortionSpread chartAngleLimit{1.15, 1.45, 6};
constexpr DistortionSpread chartAreaLimit{1.2, 1.4, 6};

/// Lays out a surface in charts, at one scale after another. Charts are made once; one that is too large for
/// the page at a scale, or whose border comes too near to itself there, is taken in smaller ones.
class SurfaceCharts {
public:
    /// @param shapes of all triangles, in the mesh's order; both must outlive this
    SurfaceCharts(const TriangleMesh& mesh, const std::vector<PatchShape>& shapes)
        : m_mesh(mesh), m_shapes(shapes) {}

    PatchLayout layoutAt(double texelsPerMetre, const PageRoom& page, int mostPages,
                         const Progress& progress);
    /// Of the latest layout, in its order: triangles as they were given, whose first corner comes first.
    const std::vector<PatchShape>& order() const { return m_order; }

private:
    /// In the plane it has the area that it has on the surface. A triangle alone keeps its shape.
    struct Chart {
        TriangleSet triangles;
        TurnedGroup laid;
        PlanePoints border;             ///< m; empty of a triangle alone, which always has room
        std::vector<std::size_t> parts; ///< charts to take in its place; none as long as none was needed
    };

    std::vector<std::size_t> makeAll(const Progress& progress);
    std::vector<std::size_t> make(std::vector<TriangleSet> pieces, const Progress& progress);
    std::optional<Chart> chartOf(const TriangleSet& triangles) const;
    std::array<TriangleSet, 2> halvesOf(const TriangleSet& piece) const;
    Chart alone(std::uint32_t triangle) const;
    std::vector<std::size_t> chosenFor(double texelsPerMetre, const PageRoom& page, const Progress& progress);

    const std::vector<std::size_t>& partsOf(std::size_t chart, const Progress& progress);

    const TriangleMesh& m_mesh;
    const std::vector<PatchShape>& m_shapes;
    DualGraph m_graph;
    std::vector<Chart> m_charts;
    std::vector<std::size_t> m_whole; ///< the charts that the surface was cut into first
    std::vector<PatchShape> m_order;
};

} // namespace esm
