#include "core/authoring/regions.h"

#include "core/fuzzy/inverse.h"

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

/// Beneath the others.
Region& layWholeOrgan(Project& project, RegionId id) {
    Region whole;
    whole.id = id;
    whole.name = "Whole organ";
    whole.colour = {152, 161, 171};
    return *project.regions.insert(project.regions.begin(), std::move(whole));
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

/// What a region sets, and of what it leaves the organ's base.
TissueValues tissueSet(const Project& project, const Region& region) {
    const RegionTissue set = evaluate(region, project.base.wallThickness);
    TissueValues tissue = set.values;
    if (!tissue.springConstant) tissue.springConstant = project.base.springConstant;
    if (set.relaxationTime) tissue.viscosity = *set.relaxationTime * *tissue.springConstant;
    if (!tissue.viscosity) tissue.viscosity = project.base.viscosity;
    return tissue;
}

/// Words in clinical units begin where the tissue is, as far as they reach. Other systems begin in the
/// middle: what they come to is not in order over their words.
void sayTissue(Region& region, const TissueValues& tissue, double wallThickness) {
    for (std::size_t i = 0; i < region.system->outputs.size(); ++i) {
        if (!isInClinicalUnits(*region.system, i)) continue;
        const auto wanted =
            inTermsOf(region.system->outputs[i], *parameterOf(*region.system, i), tissue, wallThickness);
        const auto inputs = orderedInputs(*region.system, region.inputs);
        const auto reached = wanted ? reachingInput(*region.system, inputs, i, *wanted) : std::nullopt;
        if (reached) setInput(region, region.system->inputs[reached->input].name, reached->value);
    }
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

void addRegion(Project& project, RegionId id, const Eigen::Vector3d& centre, SharedSystem system) {
    const auto box = organBox(*project.mesh, *project.network);
    // At least a tenth of the largest extent, so that a flat organ does not get a flat ellipsoid.
    const double smallest = 0.1 * box.sizes().maxCoeff();
    Region region;
    region.id = id;
    region.name = unusedName(project.regions, "Region");
    region.colour = unusedColour(project.regions);
    region.ellipsoid =
        Ellipsoid{centre, (0.25 * box.sizes()).cwiseMax(smallest), Eigen::Quaterniond::Identity()};
    project.regions.push_back(std::move(region));
    setSystem(project, id, std::move(system));
}

const Region* wholeOrganRegion(const Project& project) {
    const bool hasOne = !project.regions.empty() && !project.regions.front().ellipsoid;
    return hasOne ? &project.regions.front() : nullptr;
}

void setSystem(Project& project, RegionId region, SharedSystem system) {
    const auto place = placeOf(project.regions, region);
    Region& target = place ? project.regions[*place] : layWholeOrgan(project, region);
    const TissueValues tissue = tissueSet(project, target);
    const SharedSystem before = std::exchange(target.system, std::move(system));
    if (target.system) {
        const FuzzySystem former = before ? *before : FuzzySystem{};
        const bool startsAnew = target.system->inputs != former.inputs;
        target.inputs = inputsUnder(*target.system, former, target.inputs);
        if (startsAnew) sayTissue(target, tissue, project.base.wallThickness);
    } else {
        target.inputs.clear();
    }
    keepSystem(project, before);
}

std::optional<RegionId> applyPreset(Project& project, RegionId region, const TissuePreset& preset) {
    const Region* selected = findPart(project.regions, region);
    const bool isPart = selected && selected->ellipsoid;
    const std::optional<double> mass = preset.mass;
    if (!isPart || !preset.system) tiePreset(project.scene, preset);
    if (!isPart && mass) project.base.mass = *mass;
    if (!preset.system) return selected ? std::optional(region) : std::nullopt;
    const Region* whole = wholeOrganRegion(project);
    const RegionId chosen = !selected && whole ? whole->id : region;
    const auto place = placeOf(project.regions, chosen);
    Region& target = place ? project.regions[*place] : layWholeOrgan(project, chosen);
    const SharedSystem before = target.system;
    layPreset(target, preset);
    if (!isPart && mass) target.held.mass.reset();
    keepSystem(project, before);
    return chosen;
}

bool canMoveRegion(const Project& project, RegionId region, int above) {
    const auto place = placeOf(project.regions, region);
    return place && canMoveItem(project.regions.size(), *place, above, wholeOrganRegion(project) ? 1 : 0);
}

void moveRegion(Project& project, RegionId region, int above) {
    if (canMoveRegion(project, region, above))
        moveItem(project.regions, *placeOf(project.regions, region), above);
}

void removeRegion(Project& project, RegionId region) {
    const Region* removed = findPart(project.regions, region);
    const SharedSystem before = removed ? SharedSystem(removed->system) : nullptr;
    std::erase_if(project.regions, [&](const Region& other) { return other.id == region; });
    keepSystem(project, before);
}

void duplicateRegion(Project& project, RegionId region, RegionId copy) {
    const std::size_t place = placeOf(project.regions, region).value();
    Region made = project.regions[place];
    made.id = copy;
    made.name = unusedName(project.regions, made.name + " copy");
    made.colour = unusedColour(project.regions);
    // Aside, so that both are seen.
    if (made.ellipsoid)
        made.ellipsoid->centre +=
            made.ellipsoid->orientation * Eigen::Vector3d(made.ellipsoid->radii.x(), 0, 0);
    project.regions.insert(project.regions.begin() + static_cast<std::ptrdiff_t>(place) + 1, std::move(made));
}

void placeRegion(Project& project, RegionId region, RegionId added, const SurfaceSpot& spot,
                 SharedSystem system) {
    const auto place = placeOf(project.regions, region);
    if (place && project.regions[*place].ellipsoid) {
        Ellipsoid& ellipsoid = *project.regions[*place].ellipsoid;
        ellipsoid = laidOn(*project.mesh, spot, ellipsoid.radii);
        return;
    }
    addRegion(project, added, spot.point, std::move(system));
    project.regions.back().ellipsoid = laidOn(*project.mesh, spot, fittingRadii(project, spot.point));
}

void fixNodesInside(Project& project, RegionId region) {
    NodeSelection selection;
    selection.ellipsoid = partOf(project.regions, region).ellipsoid;
    project.scene.fixed.push_back(std::move(selection));
}

double& valueOf(BaseTissue& base, Parameter parameter) {
    if (parameter == Parameter::SpringConstant) return base.springConstant;
    return parameter == Parameter::Viscosity ? base.viscosity : base.mass;
}

} // namespace esm
