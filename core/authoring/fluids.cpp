#include "core/authoring/fluids.h"

#include "core/geometry/adjacency.h"
#include "core/model/scene_cavities.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace esm {

namespace {

/// A part's triangles over vertices of their own, so that many small parts of a large surface cost no more
/// than one of that size.
TriangleMesh wallOf(const std::vector<Eigen::Vector3d>& places, std::vector<Triangle> triangles) {
    std::vector<std::uint32_t> nodes;
    for (const Triangle& triangle : triangles)
        nodes.insert(nodes.end(), triangle.begin(), triangle.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    TriangleMesh wall;
    for (const std::uint32_t node : nodes)
        wall.vertices.push_back(places[node]);
    for (Triangle& triangle : triangles)
        for (std::uint32_t& corner : triangle)
            corner = static_cast<std::uint32_t>(std::lower_bound(nodes.begin(), nodes.end(), corner) -
                                                nodes.begin());
    wall.triangles = std::move(triangles);
    return wall;
}

/// In place of the part's entry, or after the others; none takes it out.
template<typename OfPart>
void setEntry(std::vector<OfPart>& entries, std::uint32_t part, const std::optional<OfPart>& entry) {
    const auto isMeant = [part](const OfPart& other) { return other.part == part; };
    const auto found = std::find_if(entries.begin(), entries.end(), isMeant);
    if (!entry)
        std::erase_if(entries, isMeant);
    else if (found == entries.end())
        entries.push_back(*entry);
    else
        *found = *entry;
}

/// The next one up of 1, 2 and 5 times powers of ten.
double roundedUp(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double times : {1.0, 2.0, 5.0})
        if (value <= times * decade) return times * decade;
    return 10 * decade;
}

} // namespace

std::vector<FillablePart> fillableParts(const TriangleMesh& mesh, const SpringNetwork& network,
                                        const Progress& progress) {
    const std::vector<Triangle> surface = simulatedSurface(mesh, network);
    const Parts parts = connectedParts(surface, network.restPositions.size());
    std::vector<std::vector<Triangle>> walls(parts.count);
    for (std::size_t i = 0; i < surface.size(); ++i)
        walls[parts.ofTriangle[i]].push_back(surface[i]);
    std::vector<FillablePart> result;
    result.reserve(parts.count);
    for (std::uint32_t part = 0; part < parts.count; ++part) {
        reportStep(progress, part, parts.count);
        const TriangleMesh wall = wallOf(network.restPositions, std::move(walls[part]));
        std::string problem = wallProblem(wall);
        const double volume = problem.empty() ? std::abs(enclosedVolume(wall)) : 0;
        result.push_back({part, volume, std::move(problem)});
    }
    return result;
}

std::string whyNoFluid(const Project& project) {
    if (project.mesh->triangles.empty()) return "this model has no surface that could hold a fluid";
    if (std::string why = whyNoRoom(*project.network); !why.empty()) return why;
    if (detailOf(*project.network).kind == Detail::Kind::Rigid)
        return "this organ moves as one stiff piece, whose volume never changes";
    return {};
}

// A ball of radius r whose wall is an even net of springs c bears √3·c/(2·r) at most, see
// docs/filled-parts.md. What presses from outside beyond that the wall does not hand on. A fluid under the
// pressure p is pressed together by p/K.
double usualFluidStiffness(double springConstant, double volume) {
    constexpr double keptWithin = 1e-3;
    constexpr double softest = 1e3; // Pa, where nothing is known of the wall
    const double radius = std::cbrt(3 * volume / (4 * std::numbers::pi));
    const double mostPressure = std::numbers::sqrt3 * springConstant / (2 * radius);
    return std::max(softest, roundedUp(std::max(mostPressure, softest * keptWithin) / keptWithin));
}

void fillPart(Project& project, std::uint32_t part, std::optional<double> stiffness) {
    setEntry(project.scene.fillings, part,
             stiffness ? std::optional(FluidFilling{part, *stiffness}) : std::nullopt);
}

void pressPart(Project& project, std::uint32_t part, double pressure) {
    setEntry(project.scene.pressures, part,
             pressure != 0 ? std::optional(PartPressure{part, {{0, pressure}}}) : std::nullopt);
}

} // namespace esm
