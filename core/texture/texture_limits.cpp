#include "core/texture/texture_limits.h"

#include "core/support/offenders.h"
#include "core/texture/atlas/atlas.h"

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
    std::vector<std::string> problems = fieldProblems(options);
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
