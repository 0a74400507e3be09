#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/support/fields.h"
#include "core/support/progress.h"
#include "core/texture/texture_limits.h"

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
    Charts,         ///< large pieces laid flat: few seams, triangles stretched a little
    Own,            ///< the mesh's own, for which it was made: triangles stretched as its maker left them
};
/// Whether triangles lie distorted, or at scales of their own.
constexpr bool isStretched(AtlasLayout layout) {
    return layout == AtlasLayout::Charts || layout == AtlasLayout::Own;
}
/// Those that any surface can have.
constexpr std::array<AtlasLayout, 4> atlasLayouts{AtlasLayout::Rows, AtlasLayout::MatchedRows,
                                                  AtlasLayout::UnfoldedGroups, AtlasLayout::Charts};
template<>
inline constexpr auto wordsOf<AtlasLayout> =
    std::array{Word{AtlasLayout::Rows, "rows"}, Word{AtlasLayout::MatchedRows, "matched_rows"},
               Word{AtlasLayout::UnfoldedGroups, "unfolded_groups"}, Word{AtlasLayout::Charts, "charts"},
               Word{AtlasLayout::Own, "own"}};

struct AtlasOptions {
    int size = 2048; ///< pixels, width and height of a page
    int pages = 1;
    int gap = 2; ///< pixels that stay free between any two patches
    AtlasLayout layout = AtlasLayout::MatchedRows;
    /// The density that is asked for: as many pages are made as that takes. 0: the largest that `pages` have
    /// room for.
    double texelsPerMetre = 0;

    bool operator==(const AtlasOptions&) const = default;
};
/// @param askedKey of the texels per metre that are asked for: a packed atlas has what it achieved under the
/// usual one
constexpr auto atlasFields(const char* askedKey) {
    using namespace texture_limits;
    return fieldTable(
        field("size", &AtlasOptions::size, Limits<int>{"the texture's size", 1, largestPageSize, "pixels"}),
        field("pages", &AtlasOptions::pages, Limits<int>{"the number of pages", 1, mostPages}),
        field("gap", &AtlasOptions::gap, Limits<int>{"the gap", 0, largestPageSize, "pixels"}),
        field("layout", &AtlasOptions::layout).mayBeAbsent(),
        field(askedKey, &AtlasOptions::texelsPerMetre,
              Limits<double>{"the texels per metre that are asked for", 0, mostTexelsPerMetre})
            .whenSet());
}
template<> inline constexpr auto fieldsOf<AtlasOptions> = atlasFields("texelsPerMetre");

/// Where every triangle lies in texture space: similar to its 3-D shape, one scale for all [R 4.3.2], in a
/// patch of its own or, in unfolded groups and charts, in one with neighbours whose edges it shares there
/// too. A degenerate triangle has a defined place without area. In charts and in the mesh's own layout
/// triangles are neither quite similar to their shapes nor of one scale; the mesh's own keeps no gap.
struct Atlas {
    AtlasOptions options;
    double texelsPerMetre = 0; ///< of the whole: the root of the patches' area over the surface's
    double utilisation = 0;    ///< area of the patches over the area of the pages
    std::vector<std::array<Eigen::Vector2d, 3>>
        corners;                     ///< per triangle, pixels from the page's top left corner
    std::vector<std::uint16_t> page; ///< per triangle
};
/// What was achieved. Files have it beside the options; the lists have entries of their own.
template<>
inline constexpr auto fieldsOf<Atlas> = fieldTable(field("texelsPerMetre", &Atlas::texelsPerMetre),
                                                   field("utilisation", &Atlas::utilisation));

/// As large as the pages allow, or as large as asked for. @throws InvalidModel when size, pages or gap cannot
/// hold the mesh, naming the smallest size that can, and for the mesh's own layout with all that keeps it
/// from being painted (`ownLayoutProblems()`); Cancelled
Atlas packAtlas(const TriangleMesh& mesh, const AtlasOptions& options, const Progress& progress = {});

/// Of the edges that two triangles share, the part that is a seam: the two do not lie at it side by side.
double seamShare(const TriangleMesh& mesh, const Atlas& atlas);

/// The same of the edges' length.
double seamLengthShare(const TriangleMesh& mesh, const Atlas& atlas);

/// Of each triangle the number of its patch: triangles whose shared edge is one in the page as well lie in
/// the same.
std::vector<std::uint32_t> patchNumbers(const TriangleMesh& mesh, const Atlas& atlas);

} // namespace esm
