#include "core/model/cavity.h"

#include "core/geometry/adjacency.h"
#include "core/geometry/open_borders.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

std::string nameOfPart(std::uint32_t part) {
    return "part " + std::to_string(part) + " of the surface";
}

std::string openPartProblem(const TriangleMesh& wall, std::size_t openEdges) {
    const std::vector<OpenBorder> borders = openBordersOf(wall);
    std::string problem = " is open, and a fluid would run out: " + std::to_string(openEdges) + " open edges";
    if (!borders.empty()) {
        const Eigen::Vector3d& place = wall.vertices[borders.front().loop.front()];
        problem += " in " + std::to_string(borders.size()) + " borders, the longest of " +
                   std::to_string(borders.front().loop.size()) + " edges, near (" +
                   roundedText(place.x(), 4) + ", " + roundedText(place.y(), 4) + ", " +
                   roundedText(place.z(), 4) + ") m";
    }
    return problem + "; close slits and fill holes at import";
}

/// Edges that triangles do not run along as often in one direction as in the other.
std::size_t unbalancedEdges(const std::vector<TriangleSide>& sides) {
    std::size_t count = 0;
    forEachEdge(sides, [&count](auto first, auto last) {
        count +=
            2 * std::count_if(first, last, [](const auto& side) { return side.forward; }) != last - first;
    });
    return count;
}

} // namespace

// Where each edge is run along as often in both directions, the wall's area vectors add up to zero, and a
// pressure on it moves nothing as a whole.
std::string wallProblem(const TriangleMesh& wall) {
    const std::vector<TriangleSide> sides = sidesByEdge(wall.triangles);
    if (const std::size_t open = countEdges(sides).boundary; open > 0) return openPartProblem(wall, open);
    if (const std::size_t unbalanced = unbalancedEdges(sides); unbalanced > 0)
        return " has no inside: at " + std::to_string(unbalanced) +
               " edges it turns its inside out; repair it in a modelling program";
    constexpr double leastRoundness = 1e-9; // of a volume beside its wall's area to the 3/2; a ball has 0.094
    if (!(std::abs(enclosedVolume(wall)) > leastRoundness * std::pow(surfaceArea(wall), 1.5)))
        return " encloses nothing that could be filled";
    return {};
}

// Whichever way a part faces by itself: the fluid is on the side where the volume is.
Cavity cavityOf(const std::vector<Eigen::Vector3d>& restPositions, const std::vector<Triangle>& surface,
                std::uint32_t part) {
    const Parts parts = connectedParts(surface, restPositions.size());
    if (part >= parts.count)
        throw InvalidModel(
            "there is no part " + std::to_string(part) + " of the surface; it has " +
            (parts.count == 0
                 ? "none"
                 : std::to_string(parts.count) + ", numbered from 0 in the order of their first triangles"));
    TriangleMesh wall{restPositions, {}};
    for (std::size_t i = 0; i < surface.size(); ++i)
        if (parts.ofTriangle[i] == part) wall.triangles.push_back(surface[i]);
    if (const std::string problem = wallProblem(wall); !problem.empty())
        throw InvalidModel(nameOfPart(part) + problem);
    if (enclosedVolume(wall) < 0)
        for (Triangle& triangle : wall.triangles)
            std::swap(triangle[1], triangle[2]);
    return {part, std::move(wall.triangles)};
}

std::vector<std::string> validate(const Cavity& cavity, const std::vector<Eigen::Vector3d>& restPositions) {
    std::vector<std::string> problems;
    if (!isAmount(cavity.stiffness))
        problems.push_back("the stiffness of the fluid in " + nameOfPart(cavity.part) +
                           " must be from 0 to " + roundedText(largestNumber) + " Pa, got " +
                           roundedText(cavity.stiffness));
    if (!isAmount(cavity.largestPressure))
        problems.push_back("the pressure in " + nameOfPart(cavity.part) + " must be within " +
                           roundedText(largestNumber) + " Pa, got " + roundedText(cavity.largestPressure));
    else if (!(std::abs(cavity.initialPressure) <= cavity.largestPressure))
        problems.push_back("the pressure in " + nameOfPart(cavity.part) + " begins with " +
                           roundedText(cavity.initialPressure) + " Pa, beyond the largest, " +
                           roundedText(cavity.largestPressure) + " Pa");
    const bool hasMissing = std::any_of(cavity.triangles.begin(), cavity.triangles.end(), [&](const auto& t) {
        return *std::max_element(t.begin(), t.end()) >= restPositions.size();
    });
    if (hasMissing) {
        problems.push_back(nameOfPart(cavity.part) + " names nodes that do not exist");
        return problems;
    }
    const TriangleMesh wall{restPositions, cavity.triangles};
    if (const std::string problem = wallProblem(wall); !problem.empty())
        problems.push_back(nameOfPart(cavity.part) + problem);
    else if (enclosedVolume(wall) < 0)
        problems.push_back(nameOfPart(cavity.part) + " faces into its fluid");
    return problems;
}

} // namespace esm
