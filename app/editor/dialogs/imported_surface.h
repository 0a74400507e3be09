#pragma once

#include "core/geometry/repair.h"

#include <optional>
#include <utility>
#include <vector>

namespace esm {

/// A connected part of a surface, in the file's unit and axes.
struct SurfacePart {
    std::size_t triangles = 0;
    Eigen::Vector3d extent;
};

/// A surface as it would be imported, in the file's unit and axes.
struct ImportedSurface {
    Eigen::Vector3d extent;
    std::size_t vertices = 0;
    RepairReport report;
    std::vector<SurfacePart> parts; ///< the one with the most triangles first
};

/// With all parts, and with the largest alone where that is not the same. @throws InvalidModel as repair()
std::pair<ImportedSurface, std::optional<ImportedSurface>> waysToImport(const PolygonSoup& soup);

} // namespace esm
