#include "core/authoring/regions.h"

#include "core/authoring/move_item.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <utility>

namespace esm {

namespace {

using Colour = std::array<std::uint8_t, 3>;

/// Colours that are told apart on red tissue, on both themes, and with the common colour deficiencies.
constexpr std::array<Colour, 6> regionColours{
    {{63, 182, 168}, {227, 163, 59}, {104, 146, 232}, {196, 120, 214}, {150, 190, 82}, {232, 121, 143}}};

int distance(const Colour& a, const Colour& b) {
    int sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += std::abs(int(a[i]) - int(b[i]));
    return sum;
}

/// "Region 1", or the next number that is free.
std::string unusedName(const std::vector<Region>& regions, const std::string& stem) {
    for (std::size_t number = 1;; ++number) {
        std::string name = stem + " " + std::to_string(number);
        if (std::none_of(regions.begin(), regions.end(), [&](const Region& r) { return r.name == name; }))
            return name;
    }
}

/// Beneath the others. Gives its index.
std::size_t layWholeOrgan(Project& project) {
    Region whole;
    whole.name = "Whole organ";
    whole.colour = {152, 161, 171};
    project.regions.insert(project.regions.begin(), std::move(whole));
    return 0;
}

/// Half-axes for an ellipsoid laid on the surface: round, and around a twentieth of the nodes, at least a
/// dozen, but no larger than a part of the organ; less deep than wide, so that the wall behind stays out.
Eigen::Vector3d fittingRadii(const Project& project, const Eigen::Vector3d& centre) {
    const auto& nodes = project.network->restPositions;
    std::vector<double> distances;
    distances.reserve(nodes.size());
    for (const Eigen::Vector3d& node : nodes)
        distances.push_back((node - centre).norm());
    const std::size_t wanted = std::min(nodes.size() - 1, std::max<std::size_t>(12, nodes.size() / 20));
    const auto nth = distances.begin() + static_cast<std::ptrdiff_t>(wanted);
    std::nth_element(distances.begin(), nth, distances.end());
    const double diagonal = organBox(*project.mesh, *project.network).diagonal().norm();
    const double radius = std::clamp(*nth, 0.01 * diagonal, 0.2 * diagonal);
    return {radius, radius, 0.7 * radius};
}

} // namespace

Colour unusedColour(const std::vector<Region>& regions) {
    const auto nearest = [&](const Colour& colour) {
        int least = std::numeric_limits<int>::max();
        for (const Region& region : regions)
            least = std::min(least, distance(colour, region.colour));
        return least;
    };
    return *std::max_element(regionColours.begin(), regionColours.end(),
                             [&](const Colour& a, const Colour& b) { return nearest(a) < nearest(b); });
}

void addRegion(Project& project, const Eigen::Vector3d& centre, SharedSystem system) {
    const auto box = organBox(*project.mesh, *project.network);
    // At least a tenth of the largest extent, so that a flat organ does not get a flat ellipsoid.
    const double smallest = 0.1 * box.sizes().maxCoeff();
    Region region;
    region.name = unusedName(project.regions, "Region");
    region.colour = unusedColour(project.regions);
    region.ellipsoid =
        Ellipsoid{centre, (0.25 * box.sizes()).cwiseMax(smallest), Eigen::Quaterniond::Identity()};
    project.regions.push_back(std::move(region));
    setSystem(project, project.regions.size() - 1, std::move(system));
}

std::optional<std::size_t> wholeOrganRegion(const Project& project) {
    if (project.regions.empty() || project.regions.front().ellipsoid) return std::nullopt;
    return 0;
}

std::size_t setSystem(Project& project, std::optional<std::size_t> region, SharedSystem system) {
    if (!region) region = layWholeOrgan(project);
    Region& target = project.regions[*region];
    const auto before = std::exchange(target.system, std::move(system));
    if (before && target.system && before->inputs == target.system->inputs) return *region;
    target.inputs.clear();
    if (!target.system) return *region;
    for (const auto& input : target.system->inputs)
        target.inputs.emplace_back(input.name, (input.minimum + input.maximum) / 2);
    return *region;
}

std::optional<std::size_t> applyPreset(Project& project, std::optional<std::size_t> region,
                                       const TissuePreset& preset) {
    const bool isPart = region && project.regions[*region].ellipsoid;
    const std::optional<double> mass = preset.published.mass;
    if (!isPart || !preset.system) tiePreset(project.scene, preset);
    if (!isPart && mass) project.base.mass = *mass;
    if (!preset.system) return region;
    if (!region) region = wholeOrganRegion(project);
    if (!region) region = layWholeOrgan(project);
    Region& target = project.regions[*region];
    layPreset(target, preset);
    if (!isPart && mass) target.held.mass.reset();
    return region;
}

bool canMoveRegion(const Project& project, std::size_t region, int above) {
    return canMoveItem(project.regions.size(), region, above, wholeOrganRegion(project) ? 1 : 0);
}

void moveRegion(Project& project, std::size_t region, int above) {
    if (canMoveRegion(project, region, above)) moveItem(project.regions, region, above);
}

void removeRegion(Project& project, std::size_t region) {
    project.regions.erase(project.regions.begin() + static_cast<std::ptrdiff_t>(region));
}

void duplicateRegion(Project& project, std::size_t region) {
    Region copy = project.regions[region];
    copy.name = unusedName(project.regions, copy.name + " copy");
    copy.colour = unusedColour(project.regions);
    // Aside, so that both are seen.
    if (copy.ellipsoid)
        copy.ellipsoid->centre +=
            copy.ellipsoid->orientation * Eigen::Vector3d(copy.ellipsoid->radii.x(), 0, 0);
    project.regions.insert(project.regions.begin() + static_cast<std::ptrdiff_t>(region) + 1,
                           std::move(copy));
}

void placeRegion(Project& project, std::optional<std::size_t> region, const SurfaceSpot& spot,
                 SharedSystem system) {
    if (region && project.regions[*region].ellipsoid) {
        Ellipsoid& ellipsoid = *project.regions[*region].ellipsoid;
        ellipsoid = laidOn(*project.mesh, spot, ellipsoid.radii);
        return;
    }
    addRegion(project, spot.point, std::move(system));
    project.regions.back().ellipsoid = laidOn(*project.mesh, spot, fittingRadii(project, spot.point));
}

void fixNodesInside(Project& project, std::size_t region) {
    NodeSelection selection;
    selection.ellipsoid = project.regions[region].ellipsoid;
    project.scene.fixed.push_back(std::move(selection));
}

double& valueOf(BaseTissue& base, Parameter parameter) {
    if (parameter == Parameter::SpringConstant) return base.springConstant;
    return parameter == Parameter::Viscosity ? base.viscosity : base.mass;
}

} // namespace esm
