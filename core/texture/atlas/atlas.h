#pragma once

#include "core/geometry/triangle_mesh.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace esm {

enum class AtlasLayout {
    Rows,           ///< the source's rows of triangles [R 4.3.2.2]
    MatchedRows,    ///< rows in which slants are matched and patches may be mirrored
    UnfoldedGroups, ///< neighbours unfolded together into the plane, so that only edges between groups are
                    ///< seams
};
constexpr std::array<AtlasLayout, 3> atlasLayouts{AtlasLayout::Rows, AtlasLayout::MatchedRows,
                                                  AtlasLayout::UnfoldedGroups};

/// "rows", "matched_rows", "unfolded_groups"
const char* layoutName(AtlasLayout layout);
std::optional<AtlasLayout> layoutFromName(const std::string& name);

struct AtlasOptions {
    int size = 2048; ///< pixels, width and height of a page
    int pages = 1;
    int gap = 2; ///< pixels that stay free between any two patches
    AtlasLayout layout = AtlasLayout::MatchedRows;
    /// Asked for: as many pages are made as that takes. 0: as many as the pages that there are have room for.
    double texelsPerMetre = 0;

    bool operator==(const AtlasOptions&) const = default;
};

/// Where every triangle lies in texture space: similar to its 3-D shape, one scale for all [R 4.3.2], in a
/// patch of its own or, in unfolded groups, in one with neighbours whose edges it shares there too. A
/// degenerate triangle has a defined place without area.
struct Atlas {
    AtlasOptions options;
    double texelsPerMetre = 0;
    double utilisation = 0; ///< area of the patches over the area of the pages
    std::vector<std::array<Eigen::Vector2d, 3>>
        corners;                     ///< per triangle, pixels from the page's top left corner
    std::vector<std::uint16_t> page; ///< per triangle
};

/// As large as the pages allow, or as large as asked for. @throws InvalidModel when size, pages or gap cannot
/// hold the mesh, naming the smallest size that can
Atlas packAtlas(const TriangleMesh& mesh, const AtlasOptions& options);

/// Of the edges that two triangles share, the part that is a seam: the two do not lie at it side by side.
double seamShare(const TriangleMesh& mesh, const Atlas& atlas);

} // namespace esm
