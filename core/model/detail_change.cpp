#include "core/model/detail_change.h"

#include <algorithm>
#include <limits>
#include <set>

namespace esm {

namespace {

using Points = std::vector<Eigen::Vector3d>;
using Nodes = std::vector<std::uint32_t>;

std::uint32_t nearestPoint(const Points& points, const Eigen::Vector3d& place) {
    std::uint32_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const double distance = (points[i] - place).squaredNorm();
        if (!(distance < least)) continue;
        least = distance;
        nearest = i;
    }
    return nearest;
}

Nodes nearestOf(const Points& points, const Points& places, const Nodes& nodes) {
    Nodes nearest;
    nearest.reserve(nodes.size());
    for (const std::uint32_t node : nodes)
        nearest.push_back(nearestPoint(points, places[node]));
    return nearest;
}

/// The new nodes that lie nearest to a fixed one, and those that a fixed one lies nearest to.
Nodes stillFixed(const Points& before, const Points& after, const Nodes& fixed) {
    if (fixed.empty()) return {};
    Nodes result = nearestOf(after, before, fixed);
    const std::set<std::uint32_t> wasFixed(fixed.begin(), fixed.end());
    for (std::uint32_t node = 0; node < after.size(); ++node)
        if (wasFixed.count(nearestPoint(before, after[node])) > 0) result.push_back(node);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

TetherRule asStrong(TetherRule rule, std::size_t nodesBefore, std::size_t nodesAfter) {
    const auto tethers = [&rule](std::size_t nodes) {
        const std::size_t count = (nodes + rule.every - 1) / rule.every;
        return static_cast<double>(count);
    };
    const double factor = tethers(nodesBefore) / tethers(nodesAfter);
    rule.springConstant *= factor;
    rule.viscosity *= factor;
    return rule;
}

Scene overOtherNodes(Scene scene, const Points& before, const Points& after) {
    for (NodeSelection& selection : scene.fixed)
        selection.nodes = stillFixed(before, after, selection.nodes);
    for (TetherRule& rule : scene.tethers)
        rule = asStrong(rule, before.size(), after.size());
    for (NodeForce& force : scene.forces)
        force.node = nearestPoint(after, before[force.node]);
    std::set<std::uint32_t> led;
    std::vector<NodeMove> moves;
    for (NodeMove& move : scene.moves) {
        move.node = nearestPoint(after, before[move.node]);
        if (led.insert(move.node).second) moves.push_back(std::move(move));
    }
    scene.moves = std::move(moves);
    if (scene.record.nodes) scene.record.nodes = nearestOf(after, before, *scene.record.nodes);
    return scene;
}

bool isRigid(const Project& project) {
    return detailOf(*project.network).kind == Detail::Kind::Rigid;
}

} // namespace

Project withDetail(const Project& project, const Detail& detail) {
    const Project fresh =
        makeProject(project.name, {*project.mesh, *project.importReport}, project.base.mass, detail);
    Project changed = project;
    changed.network = fresh.network;
    changed.stepping.reset();
    if (!isRigid(project) && !isRigid(fresh)) {
        changed.scene =
            overOtherNodes(project.scene, project.network->restPositions, fresh.network->restPositions);
    } else if (isRigid(project) != isRigid(fresh)) {
        changed.base = fresh.base;
        changed.base.stiffening = project.base.stiffening;
        changed.scene.fixed = fresh.scene.fixed;
        changed.scene.tethers = fresh.scene.tethers;
        changed.scene.forces.clear();
        changed.scene.moves.clear();
        changed.scene.record.nodes.reset();
    }
    return changed;
}

} // namespace esm
