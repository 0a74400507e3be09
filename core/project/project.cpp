#include "core/project/project.h"

#include "core/model/motion_model.h"
#include "core/model/scene_cavities.h"
#include "core/model/wall_hinges.h"
#include "core/project/shared_tissue.h"
#include "core/project/simulated_network.h"
#include "core/project/surroundings.h"
#include "core/project/tissue_beneath.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace esm {

namespace {

std::vector<std::uint32_t> eachOnce(std::vector<std::uint32_t> nodes) {
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

/// "flexible" of SUSILAP-G at consistency 5.5 [R C.1]. The stiffness of a membrane of springs within its
/// surface does not depend on the springs' length, so one constant suits every size and resolution.
constexpr double defaultSpringConstant = 16.26; // N/m
constexpr double defaultViscosity = 2.877;      // N·s/m

/// The same system at consistency 10.1: the springs that move the uterus as a whole [R C.1].
constexpr double rigidSpringConstant = 81.3091; // N/m
constexpr double rigidViscosity = 6;            // N·s/m

constexpr double tissueDensity = 1000; // kg/m³

/// Within this time viscosity has to overcome inertia, or the organ would wobble like no tissue. Organs of
/// anatomical size and density stay below it by far.
constexpr double longestInertia = 0.05; // s

// A closed surface whose volume comes to nothing, as a sheet with two sides, weighs as a wall too.
double defaultMass(const TriangleMesh& mesh, bool closed) {
    const double volume = closed ? std::abs(enclosedVolume(mesh)) : 0;
    return tissueDensity * (volume > 0 ? volume : surfaceArea(mesh) * usualWallThickness);
}

/// Default tissue for an organ of this mass. Mass grows with the size's cube and viscosity does not, so what
/// is larger than any organ (a unit mistaken, say) needs firmer tissue to move like one.
BaseTissue defaultTissue(double mass, double nodes, double share) {
    const double inertia = mass / nodes / (share * defaultViscosity); // s, of the organ on its tethers
    const double firmness = std::max(1.0, inertia / longestInertia);
    return {firmness * defaultSpringConstant, firmness * defaultViscosity, mass};
}

/// Tissue and tethers as those of a surface of springs suit it. Precondition: the base has its mass, and the
/// surface springs.
void tieToSurroundings(Project& project, const SpringNetwork& surface, const TriangleMesh& mesh) {
    const double share = tetherShare(surface, mesh);
    project.base = defaultTissue(project.base.mass, static_cast<double>(surface.restPositions.size()), share);
    const TetherRule rule =
        defaultTethers(surface, share, project.base.springConstant, project.base.viscosity);
    project.scene.tethers.push_back(
        asStrong(rule, outerNodes(surface).size(), outerNodes(*project.network).size()));
}

/// What moves rigidly: held by its fixed nodes, firm as the uterus.
void hangOnFixedNodes(Project& project) {
    project.base.springConstant = rigidSpringConstant;
    project.base.viscosity = rigidViscosity;
    project.scene.fixed.push_back({{motionModelFixed.begin(), motionModelFixed.end()}, std::nullopt});
}

void noteCoarseness(RepairReport& report, const Detail& detail, std::size_t nodes) {
    if (detail.kind != Detail::Kind::Nodes || nodes == detail.nodes) return;
    report.warnings.push_back(std::to_string(detail.nodes) + " nodes were asked for, but the surface keeps " +
                              std::to_string(nodes) +
                              ": its parts and edges of more than two triangles can be made no coarser");
}

/// Between both, also by rounding: a region of the value that lies beneath must not change it, nor a spring
/// constant fall below 0. Exactly one of them where the weight is 0 or 1.
double mixed(double beneath, double above, double weight) {
    if (weight == 1) return above;
    const double value = beneath + weight * (above - beneath);
    return std::clamp(value, std::min(beneath, above), std::max(beneath, above));
}

/// Mixes a region's parameters into those beneath. Regions are laid from the first to the last, each onto
/// what the ones before have made: the order is the user's, and a weight of 1 hides what lies beneath.
/// @param sizes `nodeSizes()`
void lay(TissueModel& model, const Region& region, const std::vector<double>& sizes, double wallThickness) {
    const RegionTissue tissue = evaluate(region, wallThickness);
    const TissueValues& values = tissue.values;
    const std::vector<double> weights = nodeWeights(*model.network, region);
    // What is reached with less than the weight of one node gets no more than its share: a rim that hardly
    // touches a single node would else load the whole mass upon it.
    double sum = 0, largest = 0;
    for (std::size_t node = 0; node < weights.size(); ++node) {
        sum += weights[node] * sizes[node];
        if (weights[node] > 0) largest = std::max(largest, sizes[node]);
    }
    sum = std::max(sum, largest);
    for (std::size_t node = 0; node < weights.size(); ++node) {
        const double weight = weights[node];
        if (weight == 0) continue;
        if (values.springConstant)
            model.springConstant[node] = mixed(model.springConstant[node], *values.springConstant, weight);
        const auto viscosity =
            tissue.relaxationTime
                ? std::optional(std::min(largestNumber, *tissue.relaxationTime * model.springConstant[node]))
                : values.viscosity;
        if (viscosity) model.viscosity[node] = mixed(model.viscosity[node], *viscosity, weight);
        if (values.mass) model.mass[node] = mixed(model.mass[node], *values.mass * sizes[node] / sum, weight);
    }
}

void warnOfOutputsNotReached(RegionTissue& tissue, const Project& project, const Region& region) {
    if (tissue.unreached.empty()) return;
    const auto beneath = tissueBeneath(project, region);
    for (const std::size_t output : tissue.unreached) {
        const auto parameter = parameterOf(*region.system, output);
        const std::string kept = beneath && parameter ? ": it keeps " + inWords(*beneath, *parameter) : "";
        tissue.warnings.push_back("no rule reaches " + region.system->outputs[output].name + kept);
    }
}

void tie(TissueModel& model, const std::vector<TetherRule>& rules) {
    const std::vector<OuterNode> outer = outerNodes(*model.network);
    for (const TetherRule& rule : rules)
        for (const Tether& tether : tethersOf(rule, outer))
            model.tethers.push_back(tether);
}

} // namespace

std::optional<double> relaxationTimeOf(const BaseTissue& base) {
    return relaxationTimeOf(TissueValues{base.springConstant, base.viscosity, base.mass});
}

void numberParts(Project& project) {
    numberByPlace(project.regions);
    numberByPlace(project.layers);
}

Project makeProject(std::string name, RepairedMesh surface, std::optional<double> massKilograms,
                    const Detail& detail, const Progress& progress) {
    if (massKilograms && !isMass(*massKilograms))
        throw InvalidModel("the mass must be from " + roundedText(1 / largestNumber) + " to " +
                           roundedText(largestNumber) + " kg, got " + roundedText(*massKilograms));
    ProgressParts parts(progress);
    reportProgress(progress, 0);
    const double mass = massKilograms ? *massKilograms : defaultMass(surface.mesh, surface.report.isClosed());
    auto network = std::make_shared<const SpringNetwork>(networkOf(surface.mesh, detail, parts.next(0.9)));
    noteCoarseness(surface.report, detail, network->restPositions.size());
    Project project = projectOn(std::move(network), std::move(name), std::move(surface), mass);
    reportProgress(progress, 1);
    return project;
}

Project projectOn(std::shared_ptr<const SpringNetwork> network, std::string name, RepairedMesh surface,
                  double mass) {
    Project project;
    project.name = std::move(name);
    project.network = std::move(network);
    project.base = {defaultSpringConstant, defaultViscosity, mass};
    const Detail::Kind kind = detailOf(*project.network).kind;
    if (kind == Detail::Kind::Rigid)
        hangOnFixedNodes(project);
    else if (kind == Detail::Kind::Filled)
        tieToSurroundings(project, networkFromMesh(surface.mesh), surface.mesh);
    else if (!project.network->springs.empty())
        tieToSurroundings(project, *project.network, surface.mesh);
    project.mesh = std::make_shared<const TriangleMesh>(std::move(surface.mesh));
    project.importReport = std::make_shared<const RepairReport>(std::move(surface.report));
    return project;
}

std::vector<double> nodeWeights(const SpringNetwork& network, const Region& region) {
    std::vector<double> weights;
    weights.reserve(network.restPositions.size());
    for (const Eigen::Vector3d& position : network.restPositions)
        weights.push_back(weightAt(region, position));
    return weights;
}

RegionCount countOf(const SpringNetwork& network, const Region& region) {
    const std::vector<double> weights = nodeWeights(network, region);
    RegionCount count;
    for (const double weight : weights) {
        count.nodes += weight == 1;
        count.rimNodes += weight > 0 && weight < 1;
    }
    for (const Spring& spring : network.springs) {
        const double least = std::min(weights[spring.first], weights[spring.second]);
        count.springs += least == 1;
        count.rimSprings += least > 0 && least < 1;
    }
    return count;
}

bool hasWall(const SpringNetwork& network) {
    const Detail::Kind kind = detailOf(network).kind;
    return kind != Detail::Kind::Filled && kind != Detail::Kind::Rigid;
}

TissueModel evaluateModel(const Project& project, const Scene& scene) {
    const std::size_t nodes = project.network->restPositions.size();
    TissueModel model;
    model.network = project.network;
    const std::vector<double> sizes = nodeSizes(*model.network);
    for (const double size : sizes)
        model.mass.push_back(size * (project.base.mass / static_cast<double>(nodes)));
    model.springConstant.assign(nodes, project.base.springConstant);
    model.viscosity.assign(nodes, project.base.viscosity);
    model.stiffening = project.base.stiffening;
    for (const Region& region : project.regions)
        lay(model, region, sizes, project.base.wallThickness);
    model.ownValues = sharedValues(model, project.base.wallThickness);
    if (project.base.resistsBending && hasWall(*model.network))
        model.hinges =
            wallHinges(model, simulatedSurface(*project.mesh, *model.network), project.base.wallThickness);
    tie(model, scene.tethers);
    model.fixedNodes = fixedNodesOf(*project.network, scene);
    if (!scene.fillings.empty() || !scene.pressures.empty())
        model.cavities =
            cavitiesOf(scene, *project.network, simulatedSurface(*project.mesh, *project.network));
    return model;
}

std::vector<std::uint32_t> nodesOf(const SpringNetwork& network, const NodeSelection& selection) {
    std::vector<std::uint32_t> nodes = selection.nodes;
    if (selection.ellipsoid)
        for (std::uint32_t node = 0; node < network.restPositions.size(); ++node)
            if (contains(*selection.ellipsoid, network.restPositions[node])) nodes.push_back(node);
    return eachOnce(std::move(nodes));
}

std::vector<std::uint32_t> fixedNodesOf(const SpringNetwork& network, const Scene& scene) {
    std::vector<std::uint32_t> fixed;
    for (const NodeSelection& selection : scene.fixed) {
        const std::vector<std::uint32_t> nodes = nodesOf(network, selection);
        fixed.insert(fixed.end(), nodes.begin(), nodes.end());
    }
    return eachOnce(std::move(fixed));
}

std::vector<std::string> sceneWarnings(const Scene& scene, const TissueModel& model) {
    std::vector<std::string> warnings;
    const auto& positions = model.network->restPositions;
    for (std::size_t i = 0; i < scene.fixed.size(); ++i) {
        const auto& ellipsoid = scene.fixed[i].ellipsoid;
        if (ellipsoid && std::none_of(positions.begin(), positions.end(),
                                      [&](const auto& position) { return contains(*ellipsoid, position); }))
            warnings.push_back(sceneEntry("fixed", i) +
                               ": the ellipsoid holds no node and fixes nothing; move or enlarge it");
    }
    const auto warnIfFixed = [&](const char* list, std::size_t i, std::uint32_t node, const char* fate) {
        if (std::binary_search(model.fixedNodes.begin(), model.fixedNodes.end(), node))
            warnings.push_back(sceneEntry(list, i) + ": node " + std::to_string(node) + " is fixed and " +
                               fate);
    };
    for (std::size_t i = 0; i < scene.forces.size(); ++i) {
        const NodeForce& force = scene.forces[i];
        warnIfFixed("forces", i, force.node, "does not give way");
        if (!(force.from < std::min(force.to, scene.duration)))
            warnings.push_back(sceneEntry("forces", i) +
                               ": it never acts; it should begin before its end, and "
                               "before that of the scene");
    }
    for (std::size_t i = 0; i < scene.moves.size(); ++i)
        warnIfFixed("moves", i, scene.moves[i].node, "does not follow its path");
    for (std::size_t i = 0; i < scene.splits.size(); ++i)
        if (!(scene.splits[i].time < scene.duration))
            warnings.push_back(sceneEntry("split", i) +
                               ": it never happens; it should be before the end of the scene");
    if (scene.record.nodes && scene.record.nodes->empty())
        warnings.emplace_back("record: it names no node, and a run needs one; leave the list out for all");
    return warnings;
}

RegionResult evaluateRegion(const Project& project, const Region& region) {
    RegionResult result{countOf(*project.network, region), evaluate(region, project.base.wallThickness)};
    warnOfOutputsNotReached(result.tissue, project, region);
    if (result.nodes > 0) return result;
    result.tissue.warnings.emplace_back(
        result.rimNodes > 0
            ? "no node lies inside the region, only its soft rim reaches some; move or enlarge it"
            : "the region holds no node and changes nothing; move or enlarge it");
    return result;
}

} // namespace esm
