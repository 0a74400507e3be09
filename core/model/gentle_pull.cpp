#include "core/model/gentle_pull.h"

#include "core/support/errors.h"

#include <algorithm>

namespace esm {

namespace {

/// A hand takes hold of a patch: a single node would be drawn out of the tissue as a spike. Around a node of
/// an even sphere, whose diagonal is √3 times its width, this is (0.035·√3)² of all nodes, 0.4 %.
constexpr double graspRadius = 0.035; ///< of the organ's diagonal
constexpr double pullReach = 0.1;     ///< of the organ's diagonal

bool isFixed(const TissueModel& model, std::uint32_t node) {
    return std::binary_search(model.fixedNodes.begin(), model.fixedNodes.end(), node);
}

} // namespace

// In space and not along the surface: what is grasped is the wall as a whole, both sides of it where it is
// thin. All nodes are looked at once, which costs less than a step. Fixed ones stay out, since they cannot
// follow.
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
    return !scene.forces.empty() || !scene.moves.empty() || !scene.instruments.empty() ||
           !scene.pressures.empty();
}

bool movesTissue(const Scene& scene) {
    return hasLoads(scene) || !scene.gravity.isZero();
}

// Drawn out for half a second and held for the other half: the run then shows how the tissue follows, and how
// it comes to rest. 50 frames are as many as measuring compares (tradeoff.cpp).
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
