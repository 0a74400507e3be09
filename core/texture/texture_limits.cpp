#include "core/texture/texture_limits.h"

#include "core/support/offenders.h"

namespace esm {

namespace {

/// Pixels by which rounding may carry a corner over the page's border.
constexpr double cornerTolerance = 1e-6;

bool liesOnPage(const Atlas& atlas, std::size_t triangle) {
    const double end = atlas.options.size + cornerTolerance;
    for (const Eigen::Vector2d& corner : atlas.corners[triangle])
        for (const double place : corner)
            if (!(place >= -cornerTolerance && place <= end)) return false;
    return atlas.page[triangle] < atlas.options.pages;
}

} // namespace

std::vector<std::string> validate(const AtlasOptions& options) {
    std::vector<std::string> problems;
    if (options.size < 1)
        problems.push_back("a texture of " + std::to_string(options.size) +
                           " pixels is impossible; use 1 to " +
                           std::to_string(texture_limits::largestPageSize));
    if (options.size > texture_limits::largestPageSize)
        problems.push_back("a texture of " + std::to_string(options.size) +
                           " pixels is too large; use at most " +
                           std::to_string(texture_limits::largestPageSize));
    if (options.gap < 0)
        problems.push_back("a gap of " + std::to_string(options.gap) +
                           " pixels is impossible; the smallest that fits is 0");
    if (options.gap > texture_limits::largestPageSize)
        problems.push_back("a gap of " + std::to_string(options.gap) +
                           " pixels is too wide; use a smaller gap");
    if (!(options.texelsPerMetre >= 0 && options.texelsPerMetre <= texture_limits::mostTexelsPerMetre))
        problems.push_back("the texels per metre that are asked for must be from 0 to 1e9");
    if (options.pages < 1 || options.pages > texture_limits::mostPages)
        problems.push_back(std::to_string(options.pages) + " pages are impossible; use 1 to " +
                           std::to_string(texture_limits::mostPages));
    if (problems.empty() &&
        std::int64_t{options.size} * options.size * options.pages > texture_limits::mostTexels)
        problems.push_back(std::to_string(options.pages) + " pages of " + std::to_string(options.size) +
                           " pixels are too large together; use fewer or smaller pages, at most " +
                           std::to_string(texture_limits::mostTexels / 1'000'000) + " megapixels in all");
    return problems;
}

/// A layout may come from a file: whoever scans it relies on every corner lying on its page.
std::vector<std::string> validate(const Atlas& atlas, std::size_t triangles) {
    std::vector<std::string> problems = validate(atlas.options);
    if (atlas.corners.size() != triangles || atlas.page.size() != triangles)
        problems.emplace_back("the texture layout belongs to another surface; lay it out again");
    else
        reportOffenders(problems, "triangle", "laid out beyond the texture's pages",
                        placesWhere(triangles, [&](std::size_t i) { return !liesOnPage(atlas, i); }));
    return problems;
}

} // namespace esm
