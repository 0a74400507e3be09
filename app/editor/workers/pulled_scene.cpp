#include "app/editor/workers/pulled_scene.h"

#include "app/editor/workers/grasp.h"
#include "core/model/scene_events.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double pathInterval = 0.01; ///< s; what is grasped follows the hand in three times that
constexpr double shortestPull = 0.1;  ///< s

struct PullSpan {
    std::uint32_t node;
    double begin, end; ///< s
};

std::optional<std::uint32_t> heldNode(const HandMoment& moment) {
    if (!moment.loads.pull) return std::nullopt;
    return moment.loads.pull->node;
}

/// The first that lasts; none without.
std::optional<PullSpan> firstPull(const Poke& poke) {
    const auto& moments = poke.moments;
    for (auto first = moments.begin(); first != moments.end();) {
        const auto held = heldNode(*first);
        const auto next = std::find_if(first, moments.end(),
                                       [&](const HandMoment& moment) { return heldNode(moment) != held; });
        const double end = next == moments.end() ? poke.duration : next->time;
        if (held && end - first->time >= shortestPull) return PullSpan{*held, first->time, end};
        first = next;
    }
    return std::nullopt;
}

/// Where the grasped nodes that are free are led, as displacements from rest; times from when the hand took
/// hold.
std::vector<NodeMove> movesUnder(const Poke& poke, const PullSpan& span, int intervals,
                                 const TissueModel& tissue) {
    const std::vector<Eigen::Vector3d>& rest = tissue.network->restPositions;
    Grasp grasp(tissue, rest, span.node);
    std::vector<NodeMove> moves;
    for (const std::uint32_t node : grasp.nodes())
        moves.push_back({node, {{0, Eigen::Vector3d::Zero()}}});
    for (int i = 0; i < intervals; ++i) {
        const PreviewLoads loads = loadsAt(poke, span.begin + i * pathInterval);
        if (loads.pull) grasp.setTarget(loads.pull->target);
        std::vector<PrescribedNode> prescribed;
        grasp.advance(pathInterval, prescribed);
        for (std::size_t k = 0; k < moves.size(); ++k)
            moves[k].path.push_back({(i + 1) * pathInterval, prescribed[k].position - rest[moves[k].node]});
    }
    const std::vector<std::uint32_t>& fixed = tissue.fixedNodes;
    std::erase_if(moves, [&](const NodeMove& move) {
        return std::binary_search(fixed.begin(), fixed.end(), move.node);
    });
    return moves;
}

} // namespace

bool hasPull(const Poke& poke) {
    return firstPull(poke).has_value();
}

std::optional<Scene> sceneOfPull(const Poke& poke, const Project& project, const TissueModel& tissue) {
    const Poke carried = carriedOver(poke, project.network);
    const auto span = firstPull(carried);
    if (!span) return std::nullopt;
    const int intervals = static_cast<int>(std::floor((span->end - span->begin) / pathInterval));
    Scene scene = withoutEvents(project.scene);
    scene.record = {};
    scene.moves = movesUnder(carried, *span, intervals, tissue);
    if (scene.moves.empty()) return std::nullopt;
    scene.duration = intervals * pathInterval;
    return scene;
}

} // namespace esm
