#include "core/authoring/fixed_nodes.h"

#include <algorithm>
#include <iterator>

namespace esm {

namespace {

using Nodes = std::vector<std::uint32_t>;

double squaredDistance(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& point) {
    const Eigen::Vector3d along = to - from;
    const double length = along.squaredNorm();
    const double share = length > 0 ? std::clamp(along.dot(point - from) / length, 0.0, 1.0) : 0.0;
    return (point - from - share * along).squaredNorm();
}

bool isNear(const std::vector<Eigen::Vector3d>& path, double radius, const Eigen::Vector3d& point) {
    for (std::size_t i = 0; i < path.size(); ++i)
        if (squaredDistance(path[i == 0 ? 0 : i - 1], path[i], point) <= radius * radius) return true;
    return false;
}

/// Precondition, here and of the result: sorted.
Nodes without(const Nodes& nodes, const Nodes& gone) {
    Nodes left;
    std::set_difference(nodes.begin(), nodes.end(), gone.begin(), gone.end(), std::back_inserter(left));
    return left;
}

Nodes sorted(Nodes nodes) {
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

} // namespace

Nodes nodesAlong(const SpringNetwork& network, const std::vector<Eigen::Vector3d>& path, double radius) {
    Eigen::AlignedBox3d reach;
    for (const Eigen::Vector3d& point : path)
        reach.extend(point);
    reach.min().array() -= radius;
    reach.max().array() += radius;
    Nodes nodes;
    for (std::uint32_t node = 0; node < network.restPositions.size(); ++node) {
        const Eigen::Vector3d& position = network.restPositions[node];
        if (reach.contains(position) && isNear(path, radius, position)) nodes.push_back(node);
    }
    return nodes;
}

void fixNodes(Project& project, const Nodes& nodes) {
    const Nodes added = without(sorted(nodes), fixedNodesOf(*project.network, project.scene));
    if (added.empty()) return;
    auto& fixed = project.scene.fixed;
    if (fixed.empty() || fixed.back().ellipsoid) fixed.emplace_back();
    Nodes& named = fixed.back().nodes;
    named.insert(named.end(), added.begin(), added.end());
    std::sort(named.begin(), named.end());
}

void freeNodes(Project& project, const Nodes& nodes) {
    const Nodes freed = sorted(nodes);
    auto& fixed = project.scene.fixed;
    for (NodeSelection& selection : fixed) {
        const Nodes held = nodesOf(*project.network, selection);
        const Nodes left = without(held, freed);
        if (left.size() < held.size()) selection = {left, std::nullopt};
    }
    fixed.erase(std::remove_if(fixed.begin(), fixed.end(),
                               [](const NodeSelection& selection) {
                                   return selection.nodes.empty() && !selection.ellipsoid;
                               }),
                fixed.end());
}

} // namespace esm
