#include "core/texture/atlas/atlas.h"

#include "core/geometry/adjacency.h"
#include "core/geometry/disjoint_sets.h"
#include "core/support/errors.h"
#include "core/texture/atlas/charts/surface_charts.h"
#include "core/texture/atlas/matched_rows.h"
#include "core/texture/atlas/own_layout.h"
#include "core/texture/atlas/row_layout.h"
#include "core/texture/atlas/scale_search.h"
#include "core/texture/atlas/unfolded_groups.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace esm {

namespace {

/// Below this share of its longest side a triangle's height is rounding error.
constexpr double flatness = 1e-9;

/// Lays the triangle on its longest side, as the source does [R fig. 4.8]: then the foot of its height lies
/// between the ends of the base, so that no patch is wider than its base and rows can count on that.
PatchShape shapeOf(const TriangleMesh& mesh, std::uint32_t triangle) {
    std::array<Eigen::Vector3d, 3> points;
    for (std::size_t i = 0; i < 3; ++i)
        points[i] = mesh.vertices[mesh.triangles[triangle][i]];
    PatchShape shape;
    shape.triangle = triangle;
    std::size_t longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double length = (points[(i + 1) % 3] - points[i]).norm();
        if (length <= shape.base) continue;
        shape.base = length;
        longest = i;
    }
    const Eigen::Vector3d side = points[(longest + 1) % 3] - points[longest];
    const Eigen::Vector3d slant = points[(longest + 2) % 3] - points[longest];
    const double height = side.cross(slant).norm() / shape.base;
    if (!(height > flatness * shape.base)) return {0, 0, 0, triangle, 0};
    shape.height = height;
    shape.foot = side.dot(slant) / shape.base;
    shape.firstCorner = static_cast<std::uint8_t>(longest);
    return shape;
}

/// What the search for a scale needs to know of all triangles.
struct Shapes {
    std::vector<PatchShape> all; ///< in the mesh's order
    double area = 0;             ///< m²
    double longest = 0;          ///< m, the longest side
    double smallestScale = 0;    ///< a patch has one texel on average; any less would be no texture
};

Shapes shapesOf(const TriangleMesh& mesh) {
    Shapes shapes;
    std::size_t proper = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const PatchShape shape = shapeOf(mesh, static_cast<std::uint32_t>(i));
        shapes.all.push_back(shape);
        shapes.area += shape.base * shape.height / 2;
        shapes.longest = std::max(shapes.longest, shape.base);
        proper += shape.base > 0 ? 1 : 0;
    }
    if (shapes.area > 0) shapes.smallestScale = std::sqrt(static_cast<double>(proper) / shapes.area);
    return shapes;
}

PageRoom roomOf(const AtlasOptions& options) {
    return {static_cast<double>(options.size), static_cast<double>(options.gap)};
}

/// From the order of triangles and corners in which they were laid out to the mesh's. Layouts sort by height
/// and begin at the base; all that reads an atlas goes by the mesh.
PatchLayout inMeshOrder(PatchLayout layout, const std::vector<PatchShape>& order) {
    const PatchLayout laid = layout;
    for (std::size_t i = 0; i < laid.corners.size(); ++i) {
        const PatchShape& shape = order[i];
        layout.page[shape.triangle] = laid.page[i];
        for (std::size_t corner = 0; corner < 3; ++corner)
            layout.corners[shape.triangle][(shape.firstCorner + corner) % 3] = laid.corners[i][corner];
    }
    return layout;
}

/// Single triangles in rows.
LayoutAt layoutInRows(const Shapes& shapes) {
    // Stable, so that triangles of one height keep their order and a mesh has one layout on every machine.
    std::vector<PatchShape> sorted = shapes.all;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const PatchShape& a, const PatchShape& b) { return a.height > b.height; });
    return [sorted = std::move(sorted)](const AtlasOptions& options, double scale, const Progress& progress) {
        const auto layout = options.layout == AtlasLayout::Rows ? layoutRows : layoutMatchedRows;
        return inMeshOrder(layout(sorted, scale, roomOf(options), progress), sorted);
    };
}

/// Of patches of several triangles, which `Patches` makes and keeps from one scale to the next.
template<typename Patches> LayoutAt layoutIn(const TriangleMesh& mesh, const Shapes& shapes) {
    // Shared, because a std::function is copied, and what one scale needed serves the next.
    const auto patches = std::make_shared<Patches>(mesh, shapes.all);
    return [patches](const AtlasOptions& options, double scale, const Progress& progress) {
        PatchLayout layout = patches->layoutAt(scale, roomOf(options), options.pages, progress);
        return inMeshOrder(std::move(layout), patches->order());
    };
}

LayoutAt layoutOf(const TriangleMesh& mesh, const Shapes& shapes, AtlasLayout layout) {
    if (layout == AtlasLayout::UnfoldedGroups) return layoutIn<UnfoldedGroups>(mesh, shapes);
    if (layout == AtlasLayout::Charts) return layoutIn<SurfaceCharts>(mesh, shapes);
    return layoutInRows(shapes);
}

/// Two bounds that need no packing: the patches cannot cover more than the pages, and a row cannot hold a
/// side that is longer than itself.
ScaleRange rangeOf(const Shapes& shapes, const AtlasOptions& options) {
    const double room = options.size - options.gap;
    return {shapes.smallestScale,
            std::min(room * std::sqrt(options.pages / shapes.area), room / shapes.longest)};
}

/// The largest page of which there may be so many.
int largestSizeOf(int pages) {
    const double share = std::sqrt(static_cast<double>(texture_limits::mostTexels) / pages);
    return std::min(texture_limits::largestPageSize, static_cast<int>(share));
}

/// The smallest page that holds the shapes at their smallest scale; 0 when none does. Only for the message of
/// a refusal: a size that is named can be typed in, "too small" can only be guessed at.
int smallestSize(const LayoutAt& layoutAt, double smallestScale, AtlasOptions options,
                 const Progress& progress) {
    ProgressParts attempts(progress);
    const auto fitsAt = [&](int size) {
        options.size = size;
        return fits(layoutAt(options, smallestScale, attempts.nextOfRest(shareOfAttempt)), options);
    };
    int failing = 0, fitting = largestSizeOf(options.pages);
    if (!fitsAt(fitting)) return 0;
    while (fitting - failing > 1) {
        const int middle = (failing + fitting) / 2;
        (fitsAt(middle) ? fitting : failing) = middle;
    }
    return fitting;
}

[[noreturn]] void refuseSize(const TriangleMesh& mesh, const Shapes& shapes, const AtlasOptions& options,
                             const Progress& progress) {
    const std::string what = "a texture of " + std::to_string(options.size) + " pixels cannot hold " +
                             std::to_string(shapes.all.size()) + " triangles with a gap of " +
                             std::to_string(options.gap) + " pixels on " + std::to_string(options.pages) +
                             (options.pages == 1 ? " page" : " pages");
    const int size =
        smallestSize(layoutOf(mesh, shapes, options.layout), shapes.smallestScale, options, progress);
    if (size == 0)
        throw InvalidModel(what + ", nor does the largest of " +
                           std::to_string(largestSizeOf(options.pages)) +
                           "; use a smaller gap or more pages");
    throw InvalidModel(what + "; the smallest size that fits is " + std::to_string(size));
}

ScaledLayout largest(const TriangleMesh& mesh, const Shapes& shapes, const AtlasOptions& options,
                     const Progress& progress) {
    ProgressParts parts(progress);
    const auto search = options.layout == AtlasLayout::Rows ? largestBySource : largestByHeight;
    ScaledLayout found =
        search(layoutOf(mesh, shapes, options.layout), options, rangeOf(shapes, options), parts.next(0.9));
    if (found.scale == 0) refuseSize(mesh, shapes, options, parts.rest());
    return found;
}

/// A given scale needs no search, but pages as many as it takes. Area and longest side are compared first, so
/// that far too many texels are refused without laying them out.
ScaledLayout asDenseAsAsked(const TriangleMesh& mesh, const Shapes& shapes, AtlasOptions options,
                            const Progress& progress) {
    const std::int64_t pageTexels = std::int64_t{options.size} * options.size;
    options.pages = static_cast<int>(
        std::min<std::int64_t>(texture_limits::mostPages, texture_limits::mostTexels / pageTexels));
    const double scale = options.texelsPerMetre, room = options.size - options.gap;
    PatchLayout layout;
    if (scale * scale * shapes.area < room * room * options.pages && scale * shapes.longest < room)
        layout = layoutOf(mesh, shapes, options.layout)(options, scale, progress);
    if (!fits(layout, options))
        throw InvalidModel("so many texels per metre do not fit on " + std::to_string(options.pages) +
                           (options.pages == 1 ? " page of " : " pages of ") + std::to_string(options.size) +
                           " pixels; use fewer, or larger pages");
    return {scale, std::move(layout)};
}

/// A size below 1 is told which one fits, as any other that is too small.
void checkOptions(AtlasOptions options) {
    options.size = std::max(options.size, 1);
    const std::vector<std::string> problems = validate(options);
    if (!problems.empty()) throw InvalidModel(problems);
}

} // namespace

Atlas packAtlas(const TriangleMesh& mesh, const AtlasOptions& options, const Progress& progress) {
    checkOptions(options);
    const Shapes shapes = shapesOf(mesh);
    if (!(shapes.area > 0) || !std::isfinite(shapes.area))
        throw InvalidModel("the model has no surface to lay out; textures need triangles with an area");
    reportProgress(progress, 0);
    if (options.layout == AtlasLayout::Own) {
        Atlas own = ownLayout(mesh, options);
        reportProgress(progress, 1);
        return own;
    }
    ScaledLayout best = options.texelsPerMetre > 0 ? asDenseAsAsked(mesh, shapes, options, progress)
                                                   : largest(mesh, shapes, options, progress);
    Atlas atlas;
    atlas.options = options;
    if (options.texelsPerMetre > 0) atlas.options.pages = best.layout.pages;
    atlas.texelsPerMetre = best.scale;
    atlas.corners = std::move(best.layout.corners);
    atlas.page = std::move(best.layout.page);
    const double pageArea = static_cast<double>(options.size) * options.size * atlas.options.pages;
    atlas.utilisation = shapes.area * atlas.texelsPerMetre * atlas.texelsPerMetre / pageArea;
    reportProgress(progress, 1);
    return atlas;
}

namespace {

/// Calls `visit(first, second, areJoined)` with both sides of every edge that triangles share, of more than
/// two the first ones, which are never joined.
template<typename Visit>
void forEachSharedEdge(const TriangleMesh& mesh, const Atlas& atlas, const Visit& visit) {
    const auto placeOf = [&](const TriangleSide& side, std::uint32_t vertex) {
        const Triangle& corners = mesh.triangles[side.triangle];
        const auto corner = std::find(corners.begin(), corners.end(), vertex) - corners.begin();
        return atlas.corners[side.triangle][static_cast<std::size_t>(corner)];
    };
    forEachEdge(sidesByEdge(mesh.triangles), [&](auto first, auto last) {
        if (last - first < 2) return;
        const auto second = first + 1;
        visit(*first, *second,
              last - first == 2 && atlas.page[first->triangle] == atlas.page[second->triangle] &&
                  placeOf(*first, first->edge.first) == placeOf(*second, first->edge.first) &&
                  placeOf(*first, first->edge.second) == placeOf(*second, first->edge.second));
    });
}

template<typename WeightOf>
double seamShareBy(const TriangleMesh& mesh, const Atlas& atlas, const WeightOf& weightOf) {
    double shared = 0, joined = 0;
    forEachSharedEdge(mesh, atlas, [&](const TriangleSide& side, const TriangleSide&, bool areJoined) {
        const double weight = weightOf(side.edge);
        shared += weight;
        joined += areJoined ? weight : 0;
    });
    return shared > 0 ? 1 - joined / shared : 0;
}

} // namespace

double seamShare(const TriangleMesh& mesh, const Atlas& atlas) {
    return seamShareBy(mesh, atlas, [](const Edge&) { return 1.0; });
}

double seamLengthShare(const TriangleMesh& mesh, const Atlas& atlas) {
    return seamShareBy(mesh, atlas, [&](const Edge& edge) {
        return (mesh.vertices[edge.second] - mesh.vertices[edge.first]).norm();
    });
}

std::vector<std::uint32_t> patchNumbers(const TriangleMesh& mesh, const Atlas& atlas) {
    DisjointSets patches(mesh.triangles.size());
    forEachSharedEdge(mesh, atlas, [&](const TriangleSide& one, const TriangleSide& other, bool areJoined) {
        if (areJoined) patches.join(one.triangle, other.triangle);
    });
    std::vector<std::uint32_t> numbers;
    numbers.reserve(mesh.triangles.size());
    for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
        numbers.push_back(patches.lowest(triangle));
    return numbers;
}

} // namespace esm
