#include "core/model/gentle_pull.h"

#include "core/support/errors.h"

#include <algorithm>

namespace esm {

namespace {

constexpr double graspRadius = 0.035; ///< of the organ's diagonal
constexpr double pullReach = 0.1;     ///< of the organ's diagonal

bool isFixed(const TissueModel& model, std::uint32_t node) {
    return std::binary_search(model.fixedNodes.begin(), model.fixedNodes.end(), node);
}

} // namespace

std::vector<std::uint32_t> graspedNodes(const TissueModel& model, std::uint32_t node) {
    std::vector<std::uint32_t> nodes{node};
    const auto& rest = model.network->restPositions;
    const double radius = graspRadius * boundingBox(rest).diagonal().norm();
    for (std::uint32_t i = 0; i < rest.size(); ++i)
        if (i != node && !isFixed(model, i) && (rest[i] - rest[node]).norm() < radius) nodes.push_back(i);
    return nodes;
}

// The direction is oblique to all axes: even an organ that is symmetric about them has one outermost node,
// the same one every time.
std::optional<GentlePull> gentlePull(const TissueModel& model) {
    const auto& rest = model.network->restPositions;
    const auto box = boundingBox(rest);
    const Eigen::Vector3d direction = Eigen::Vector3d(0.8, 0.5, 0.35).normalized();
    std::optional<std::uint32_t> outermost;
    for (std::uint32_t i = 0; i < rest.size(); ++i)
        if (!isFixed(model, i) && (!outermost || rest[i].dot(direction) > rest[*outermost].dot(direction)))
            outermost = i;
    if (!outermost) return std::nullopt;
    return GentlePull{*outermost, pullReach * box.diagonal().norm() * direction};
}

bool hasLoads(const Scene& scene) {
    return !scene.forces.empty() || !scene.moves.empty() || !scene.instruments.empty();
}

bool movesTissue(const Scene& scene) {
    return hasLoads(scene) || !scene.gravity.isZero();
}

Scene withGentlePull(const TissueModel& model, Scene scene) {
    const auto pull = gentlePull(model);
    if (!pull) throw InvalidModel("every node is fixed: nothing can move");
    scene.duration = 1;
    scene.record = {0.02, {}};
    for (const std::uint32_t node : graspedNodes(model, pull->node))
        scene.moves.push_back({node, {{0, Eigen::Vector3d::Zero()}, {0.5, pull->furthest}}});
    return scene;
}

} // namespace esm
