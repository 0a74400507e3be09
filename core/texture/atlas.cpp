#include "core/texture/atlas.h"

#include "core/support/errors.h"
#include "core/texture/matched_rows.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace esm {

namespace {

/// Below this share of its longest side a triangle's height is rounding error.
constexpr double flatness = 1e-9;

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

/// What the search for a scale needs to know of all shapes.
struct Shapes {
    std::vector<PatchShape> all; ///< tallest first
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
    std::stable_sort(shapes.all.begin(), shapes.all.end(),
                     [](const PatchShape& a, const PatchShape& b) { return a.height > b.height; });
    return shapes;
}

RowLayout layoutAt(const Shapes& shapes, const AtlasOptions& options, double scale) {
    const RowPage page{static_cast<double>(options.size), static_cast<double>(options.gap)};
    return options.layout == AtlasLayout::Rows ? layoutRows(shapes.all, scale, page)
                                               : layoutMatchedRows(shapes.all, scale, page);
}

bool fits(const RowLayout& layout, const AtlasOptions& options) {
    return layout.pages > 0 && layout.pages <= options.pages;
}

/// The source's iteration [R 4.9, 4.10] down to a scale that fits. It slows down the nearer it comes, so
/// halving the interval between the last two scales ends it. Precondition: the smallest scale fits.
double largestScale(const Shapes& shapes, const AtlasOptions& options) {
    const double room = options.size - options.gap;
    const double available = room * options.pages;
    double fitting = shapes.smallestScale;
    double failing = std::min(std::sqrt(room * available / shapes.area), room / shapes.longest);
    for (double scale = failing; scale > fitting;) {
        const RowLayout layout = layoutAt(shapes, options, scale);
        if (fits(layout, options)) {
            fitting = scale;
            break;
        }
        failing = scale;
        scale *= std::sqrt(1 / (1 + std::max(layout.height - available, 0.05 * available) / (5 * available)));
    }
    while (failing > fitting * 1.0005) {
        const double middle = (fitting + failing) / 2;
        (fits(layoutAt(shapes, options, middle), options) ? fitting : failing) = middle;
    }
    return fitting;
}

/// The largest page of which there may be so many.
int largestSizeOf(int pages) {
    const double share = std::sqrt(static_cast<double>(texture_limits::mostTexels) / pages);
    return std::min(texture_limits::largestPageSize, static_cast<int>(share));
}

/// The smallest page that holds the shapes at their smallest scale; 0 when none does.
int smallestSize(const Shapes& shapes, AtlasOptions options) {
    const auto fitsAt = [&](int size) {
        options.size = size;
        return fits(layoutAt(shapes, options, shapes.smallestScale), options);
    };
    int failing = 0, fitting = largestSizeOf(options.pages);
    if (!fitsAt(fitting)) return 0;
    while (fitting - failing > 1) {
        const int middle = (failing + fitting) / 2;
        (fitsAt(middle) ? fitting : failing) = middle;
    }
    return fitting;
}

[[noreturn]] void refuseSize(const Shapes& shapes, const AtlasOptions& options) {
    const std::string what = "a texture of " + std::to_string(options.size) + " pixels cannot hold " +
                             std::to_string(shapes.all.size()) + " triangles with a gap of " +
                             std::to_string(options.gap) + " pixels on " + std::to_string(options.pages) +
                             (options.pages == 1 ? " page" : " pages");
    const int size = smallestSize(shapes, options);
    if (size == 0)
        throw InvalidModel(what + ", nor does the largest of " +
                           std::to_string(largestSizeOf(options.pages)) +
                           "; use a smaller gap or more pages");
    throw InvalidModel(what + "; the smallest size that fits is " + std::to_string(size));
}

/// A size below 1 is told which one fits, as any other that is too small.
void checkOptions(AtlasOptions options) {
    options.size = std::max(options.size, 1);
    const std::vector<std::string> problems = validate(options);
    if (!problems.empty()) throw InvalidModel(problems);
}

/// From the shapes' order of triangles and corners to the mesh's.
void assign(Atlas& atlas, const Shapes& shapes, const RowLayout& layout) {
    atlas.corners.resize(shapes.all.size());
    atlas.page.resize(shapes.all.size());
    for (std::size_t i = 0; i < shapes.all.size(); ++i) {
        const PatchShape& shape = shapes.all[i];
        atlas.page[shape.triangle] = layout.page[i];
        for (std::size_t corner = 0; corner < 3; ++corner)
            atlas.corners[shape.triangle][(shape.firstCorner + corner) % 3] = layout.corners[i][corner];
    }
}

} // namespace

const char* layoutName(AtlasLayout layout) {
    return layout == AtlasLayout::Rows ? "rows" : "matched_rows";
}

std::optional<AtlasLayout> layoutFromName(const std::string& name) {
    for (const AtlasLayout layout : {AtlasLayout::Rows, AtlasLayout::MatchedRows})
        if (name == layoutName(layout)) return layout;
    return std::nullopt;
}

Atlas packAtlas(const TriangleMesh& mesh, const AtlasOptions& options) {
    checkOptions(options);
    const Shapes shapes = shapesOf(mesh);
    if (!(shapes.area > 0) || !std::isfinite(shapes.area))
        throw InvalidModel("the model has no surface to lay out; textures need triangles with an area");
    if (!fits(layoutAt(shapes, options, shapes.smallestScale), options)) refuseSize(shapes, options);
    Atlas atlas;
    atlas.options = options;
    atlas.texelsPerMetre = largestScale(shapes, options);
    assign(atlas, shapes, layoutAt(shapes, options, atlas.texelsPerMetre));
    const double pageArea = static_cast<double>(options.size) * options.size * options.pages;
    atlas.utilisation = shapes.area * atlas.texelsPerMetre * atlas.texelsPerMetre / pageArea;
    return atlas;
}

} // namespace esm
