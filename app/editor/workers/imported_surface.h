#pragma once

#include "core/geometry/open_borders.h"
#include "core/geometry/repair.h"

#include <memory>
#include <string>
#include <vector>

namespace esm {

/// A connected part of a surface, in the file's unit and axes.
struct SurfacePart {
    std::size_t triangles = 0;
    Eigen::Vector3d extent;
};

/// A surface as it would be imported, in the file's unit and axes.
struct ImportedSurface {
    std::shared_ptr<const TriangleMesh> mesh; ///< never null
    Eigen::Vector3d extent;
    RepairReport report;
    std::vector<SurfacePart> parts;  ///< the one with the most triangles first
    std::vector<OpenBorder> borders; ///< that are left
    std::size_t meetingPairs = 0;    ///< of triangles that run through each other
    /// Why its texture coordinates cannot be laid out by; empty where they can, or where it has none.
    std::vector<std::string> coordinateProblems;
};

/// @throws InvalidModel as repair(), Cancelled
ImportedSurface importedSurface(const PolygonSoup& soup, const RepairOptions& options,
                                const Progress& progress = {});

} // namespace esm
