#pragma once

#include "core/support/fields.h"

#include <cstddef>
#include <string>
#include <vector>

namespace esm {

/// What repair found and did. Counts named "before" are of the file: after welding, before any triangle is
/// dropped.
struct RepairReport {
    std::size_t mergedVertices = 0;
    std::size_t splitPolygons = 0;       ///< polygons of more than three corners
    std::size_t degenerateTriangles = 0; ///< dropped: two equal corners or no area
    std::size_t duplicateTriangles = 0;  ///< dropped: the same three corners in any order
    std::size_t unusedVertices = 0;      ///< dropped
    /// Of the file, and not dropped: run the other way in the result, to agree with their neighbours or to
    /// face outwards.
    std::size_t flippedTriangles = 0;
    std::size_t closedSlitEdges = 0;                  ///< border edges that stitching joined
    std::size_t filledHoles = 0, filledHoleEdges = 0; ///< holes, and border edges that they had
    std::size_t refusedHoles = 0; ///< left open, though they have few enough edges (`fillHoles()`)
    std::size_t droppedParts = 0, droppedPartEdges = 0; ///< by `KeepParts::Largest`, and their border edges
    std::size_t components = 0;                         ///< connected parts that were kept
    std::size_t boundaryEdgesBefore = 0, nonManifoldEdgesBefore = 0;
    std::size_t boundaryEdges = 0,
                nonManifoldEdges = 0;  ///< of the result: one triangle, more than two triangles
    std::size_t inconsistentEdges = 0; ///< between two triangles that cannot agree, as on a Möbius strip
    std::vector<std::string> warnings; ///< for people: what was repaired and what remains

    /// Border edges that there were to close: in the file, once faulty triangles are dropped.
    std::size_t boundaryEdgesFound() const {
        return boundaryEdges + closedSlitEdges + filledHoleEdges + droppedPartEdges;
    }
    std::size_t removedTriangles() const { return degenerateTriangles + duplicateTriangles; }
    /// Whether the mesh encloses a volume: no border, and an inside and an outside everywhere.
    bool isClosed() const { return boundaryEdges + inconsistentEdges == 0; }
};
template<>
inline constexpr auto fieldsOf<RepairReport> = fieldTable(
    field("mergedVertices", &RepairReport::mergedVertices),
    field("splitPolygons", &RepairReport::splitPolygons),
    field("degenerateTriangles", &RepairReport::degenerateTriangles),
    field("duplicateTriangles", &RepairReport::duplicateTriangles),
    field("unusedVertices", &RepairReport::unusedVertices),
    field("flippedTriangles", &RepairReport::flippedTriangles),
    field("droppedParts", &RepairReport::droppedParts), field("components", &RepairReport::components),
    field("boundaryEdgesBefore", &RepairReport::boundaryEdgesBefore),
    field("nonManifoldEdgesBefore", &RepairReport::nonManifoldEdgesBefore),
    field("boundaryEdges", &RepairReport::boundaryEdges),
    field("nonManifoldEdges", &RepairReport::nonManifoldEdges),
    field("inconsistentEdges", &RepairReport::inconsistentEdges), field("warnings", &RepairReport::warnings),
    field("closedSlitEdges", &RepairReport::closedSlitEdges).whenSet(),
    field("filledHoles", &RepairReport::filledHoles).whenSet(),
    field("filledHoleEdges", &RepairReport::filledHoleEdges).whenSet(),
    field("refusedHoles", &RepairReport::refusedHoles).whenSet(),
    field("droppedPartEdges", &RepairReport::droppedPartEdges).whenSet());

/// Border edges that repair leaves, of two kinds that no option closes.
struct LeftOpen {
    std::size_t refusedEdges = 0; ///< of the holes that were refused
    std::size_t looseEdges = 0;   ///< of no hole (`Borders::looseEdges`)
};

/// For people: what was repaired and what remains, a sentence each.
std::vector<std::string> repairWarnings(const RepairReport& report, const LeftOpen& left);

} // namespace esm
