#include "core/project/detail_change.h"

#include "core/geometry/adjacency.h"
#include "core/model/cavity.h"
#include "core/model/scene_cavities.h"
#include "core/project/simulated_network.h"
#include "core/project/surroundings.h"
#include "core/support/errors.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace esm {

namespace {

using Points = std::vector<Eigen::Vector3d>;
using Nodes = std::vector<std::uint32_t>;

/// Points in the order of one coordinate, so that only those near in it have to be looked at. From the place
/// on, both ways, until the coordinate alone is farther than the best: on a surface of n points some √n of
/// them, and all only where it lies flat across that coordinate. A tree would look at fewer, for more code;
/// this is asked once per node and change of detail.
class PointSearch {
public:
    explicit PointSearch(const Points& points) : m_points(points), m_order(points.size()) {
        std::iota(m_order.begin(), m_order.end(), 0U);
        std::sort(m_order.begin(), m_order.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return points[a].x() < points[b].x(); });
    }

    /// Of points equally near the first.
    std::uint32_t nearest(const Eigen::Vector3d& place) const {
        std::pair<double, std::uint32_t> best{std::numeric_limits<double>::infinity(), 0};
        // Whether those farther on may be nearer still.
        const auto lookAt = [&](std::uint32_t point) {
            const Eigen::Vector3d way = m_points[point] - place;
            best = std::min(best, {way.squaredNorm(), point});
            return way.x() * way.x() <= best.first;
        };
        const auto middle =
            std::lower_bound(m_order.begin(), m_order.end(), place.x(),
                             [&](std::uint32_t point, double x) { return m_points[point].x() < x; });
        for (auto point = middle; point != m_order.end() && lookAt(*point);)
            ++point;
        for (auto point = std::make_reverse_iterator(middle); point != m_order.rend() && lookAt(*point);)
            ++point;
        return best.second;
    }

    Nodes nearest(const Points& places, const Nodes& nodes, const Progress& progress) const {
        Nodes found;
        found.reserve(nodes.size());
        for (const std::uint32_t node : nodes) {
            reportStep(progress, found.size(), nodes.size());
            found.push_back(nearest(places[node]));
        }
        return found;
    }

private:
    const Points& m_points;
    Nodes m_order;
};

Nodes commonOf(Nodes some, const Nodes& sorted) {
    std::erase_if(
        some, [&](std::uint32_t node) { return !std::binary_search(sorted.begin(), sorted.end(), node); });
    return some;
}

Nodes everyNode(const SpringNetwork& network) {
    Nodes nodes(network.restPositions.size());
    std::iota(nodes.begin(), nodes.end(), 0U);
    return nodes;
}

/// The new nodes that lie nearest to a fixed one, and those that a fixed one lies nearest to. The first alone
/// would leave gaps between where the new nodes are the denser ones; the second alone might fix none where
/// they are the sparser. What lies within a body fixes nothing of a surface, nor the other way round.
Nodes stillFixed(const SpringNetwork& former, const SpringNetwork& present, const PointSearch& afterwards,
                 Nodes fixed, const Progress& progress) {
    if (fixed.empty()) return {};
    ProgressParts parts(progress);
    if (former.lattice && !present.lattice) fixed = commonOf(fixed, surfaceNodes(*former.lattice));
    Nodes result = afterwards.nearest(former.restPositions, fixed, parts.next(0.5));
    const std::set<std::uint32_t> wasFixed(fixed.begin(), fixed.end());
    const PointSearch formerly(former.restPositions);
    const Progress looking = parts.rest();
    const Nodes candidates =
        present.lattice && !former.lattice ? surfaceNodes(*present.lattice) : everyNode(present);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        reportStep(looking, i, candidates.size());
        const std::uint32_t node = candidates[i];
        if (wasFixed.count(formerly.nearest(present.restPositions[node])) > 0) result.push_back(node);
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

Scene overOtherNodes(Scene scene, const SpringNetwork& former, const SpringNetwork& present,
                     const Progress& progress) {
    const Points& before = former.restPositions;
    ProgressParts parts(progress);
    const double share = 1 / static_cast<double>(scene.fixed.size() + 1);
    const PointSearch afterwards(present.restPositions);
    for (NodeSelection& selection : scene.fixed)
        selection.nodes = stillFixed(former, present, afterwards, selection.nodes, parts.next(share));
    for (TetherRule& rule : scene.tethers)
        rule = asStrong(rule, outerNodes(former).size(), outerNodes(present).size());
    scene.splits.clear();
    const auto isMadeBySplit = [&](std::uint32_t node) { return node >= before.size(); };
    const auto actsOnOne = [&](const auto& load) { return isMadeBySplit(load.node); };
    std::erase_if(scene.forces, actsOnOne);
    std::erase_if(scene.moves, actsOnOne);
    for (NodeForce& force : scene.forces)
        force.node = afterwards.nearest(before[force.node]);
    std::set<std::uint32_t> led;
    std::vector<NodeMove> moves;
    for (NodeMove& move : scene.moves) {
        move.node = afterwards.nearest(before[move.node]);
        if (led.insert(move.node).second) moves.push_back(std::move(move));
    }
    scene.moves = std::move(moves);
    if (!scene.record.nodes) return scene;
    std::erase_if(*scene.record.nodes, isMadeBySplit);
    scene.record.nodes = afterwards.nearest(before, *scene.record.nodes, parts.rest());
    return scene;
}

/// The connected parts of a simulated surface, and where they lie.
struct PartsOfSurface {
    const Points& places;
    std::vector<Triangle> triangles;
    Parts parts;
};

PartsOfSurface partsOf(const Project& project) {
    const Points& places = project.network->restPositions;
    std::vector<Triangle> triangles = simulatedSurface(*project.mesh, *project.network);
    Parts parts = connectedParts(triangles, places.size());
    return {places, std::move(triangles), std::move(parts)};
}

/// The part of the other surface that most corners of a part lie nearest to. Numbers follow the order of
/// triangles, which a coarser surface may change.
std::uint32_t partThere(const PartsOfSurface& here, std::uint32_t part, const PartsOfSurface& there) {
    std::map<std::uint32_t, std::uint32_t> partOfNode, counts;
    for (std::size_t i = 0; i < there.triangles.size(); ++i)
        for (const std::uint32_t node : there.triangles[i])
            partOfNode[node] = there.parts.ofTriangle[i];
    const PointSearch search(there.places);
    for (std::size_t i = 0; i < here.triangles.size(); ++i) {
        if (here.parts.ofTriangle[i] != part) continue;
        const auto found = partOfNode.find(search.nearest(here.places[here.triangles[i][0]]));
        if (found != partOfNode.end()) ++counts[found->second];
    }
    const auto most = std::max_element(counts.begin(), counts.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == counts.end() ? part : most->first;
}

void keepFluids(Scene& scene, const Project& before, const Project& after) {
    if (scene.fillings.empty() && scene.pressures.empty()) return;
    const PartsOfSurface here = partsOf(before), there = partsOf(after);
    for (auto& filling : scene.fillings)
        filling.part = partThere(here, filling.part, there);
    for (auto& pressure : scene.pressures)
        pressure.part = partThere(here, pressure.part, there);
}

/// Told of the organ, not of an entry of its scene, which nobody has in hand who changes its detail.
/// @throws InvalidModel where the nodes leave no room for the fluids that it holds
void requireRoomForFluids(const Project& project) {
    const std::vector<std::uint32_t> parts = fluidParts(project.scene);
    if (parts.empty()) return;
    if (const std::string why = whyNoRoom(*project.network); !why.empty())
        throw InvalidModel(why + "; " + adviceOnRoom);
    const std::vector<Triangle> surface = simulatedSurface(*project.mesh, *project.network);
    try {
        for (const std::uint32_t part : parts)
            cavityOf(project.network->restPositions, surface, part);
    } catch (const InvalidModel& problem) {
        throw InvalidModel("these nodes leave no room for the organ's fluid: " + std::string(problem.what()));
    }
}

bool movesRigidly(const SpringNetwork& network) {
    return detailOf(network).kind == Detail::Kind::Rigid;
}

/// Another way to be held and moved, and other tissue.
void takeDefaults(Project& changed, const Project& fresh) {
    changed.base = fresh.base;
    changed.scene.fixed = fresh.scene.fixed;
    changed.scene.tethers = fresh.scene.tethers;
    changed.scene.forces.clear();
    changed.scene.moves.clear();
    removeFluids(changed.scene);
    changed.scene.splits.clear();
    changed.scene.record.nodes.reset();
}

} // namespace

Detail hollowDetail(const Project& project) {
    return {Detail::Kind::EveryVertex, 0, {}, project.network->sheet || project.network->lattice};
}

Project withDetail(const Project& project, const Detail& detail, const Progress& progress) {
    ProgressParts parts(progress);
    reportProgress(progress, 0);
    auto network = std::make_shared<const SpringNetwork>(networkOf(*project.mesh, detail, parts.next(0.8)));
    return withNetwork(project, std::move(network), parts.rest());
}

Project withNetwork(const Project& project, std::shared_ptr<const SpringNetwork> network,
                    const Progress& progress) {
    reportProgress(progress, 0);
    Project changed = project;
    changed.network = std::move(network);
    changed.stepping.reset();
    if (project.network->lattice || changed.network->lattice) changed.accuracy = nullptr;
    const bool wasRigid = movesRigidly(*project.network), isRigid = movesRigidly(*changed.network);
    if (!wasRigid && !isRigid) {
        changed.scene = overOtherNodes(project.scene, *project.network, *changed.network, progress);
        keepFluids(changed.scene, project, changed);
    } else if (wasRigid != isRigid) {
        takeDefaults(changed, projectOn(changed.network, project.name, {*project.mesh, *project.importReport},
                                        project.base.mass));
        changed.base.stiffening = project.base.stiffening;
        changed.base.wallThickness = project.base.wallThickness;
        changed.base.resistsBending = project.base.resistsBending;
    }
    requireRoomForFluids(changed);
    reportProgress(progress, 1);
    return changed;
}

} // namespace esm
