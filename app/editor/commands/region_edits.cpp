#include "app/editor/commands/region_edits.h"

#include "core/exchange/fuzzy_file.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

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

/// The colour that is told apart best from those in use.
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

std::string unusedName(const std::vector<Region>& regions) {
    for (std::size_t number = 1;; ++number) {
        std::string name = "Region " + std::to_string(number);
        if (std::none_of(regions.begin(), regions.end(), [&](const Region& r) { return r.name == name; }))
            return name;
    }
}

} // namespace

void addRegion(Project& project, const Eigen::Vector3d& centre) {
    const auto box = organBox(*project.mesh, *project.network);
    // At least a tenth of the largest extent, so that a flat organ does not get a flat ellipsoid.
    const double smallest = 0.1 * box.sizes().maxCoeff();
    Region region;
    region.name = unusedName(project.regions);
    region.colour = unusedColour(project.regions);
    region.ellipsoid =
        Ellipsoid{centre, (0.25 * box.sizes()).cwiseMax(smallest), Eigen::Quaterniond::Identity()};
    project.regions.push_back(std::move(region));
    setSystem(project, project.regions.size() - 1,
              std::make_shared<const FuzzySystem>(fuzzyPreset("susilap-g")));
}

std::optional<std::size_t> wholeOrganRegion(const Project& project) {
    if (project.regions.empty() || project.regions.front().ellipsoid) return std::nullopt;
    return 0;
}

std::size_t setSystem(Project& project, std::optional<std::size_t> region,
                      std::shared_ptr<const FuzzySystem> system) {
    if (!region) {
        Region whole;
        whole.name = "Whole organ";
        whole.colour = {152, 161, 171};
        project.regions.insert(project.regions.begin(), std::move(whole));
        region = 0;
    }
    Region& target = project.regions[*region];
    target.system = std::move(system);
    target.inputs.clear();
    if (!target.system) return *region;
    for (const auto& input : target.system->inputs)
        target.inputs.emplace_back(input.name, (input.minimum + input.maximum) / 2);
    return *region;
}

void setInput(Region& region, const std::string& variable, double value) {
    const auto found = std::find_if(region.inputs.begin(), region.inputs.end(),
                                    [&](const auto& input) { return input.first == variable; });
    if (found != region.inputs.end())
        found->second = value;
    else
        region.inputs.emplace_back(variable, value);
}

bool canMoveRegion(const Project& project, std::size_t region, int above) {
    const std::size_t lowest = wholeOrganRegion(project) ? 1 : 0;
    if (region < lowest || region >= project.regions.size()) return false;
    return above > 0 ? region + 1 < project.regions.size() : region > lowest;
}

void moveRegion(Project& project, std::size_t region, int above) {
    if (!canMoveRegion(project, region, above)) return;
    std::swap(project.regions[region], project.regions[above > 0 ? region + 1 : region - 1]);
}

void removeRegion(Project& project, std::size_t region) {
    project.regions.erase(project.regions.begin() + static_cast<std::ptrdiff_t>(region));
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
