#include "core/dynamics/measure/scene_stages.h"

#include "core/support/errors.h"

#include <algorithm>

namespace esm {

namespace {

/// The places of splits in the order in which they happen. Those of one time keep the order of the scene,
/// since a later one may name nodes that an earlier one made.
std::vector<std::size_t> inOrderOfTime(const Scene& scene) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < scene.splits.size(); ++i)
        if (scene.splits[i].time < scene.duration) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return scene.splits[a].time < scene.splits[b].time;
    });
    return order;
}

/// Each stage holds the whole organ, of about 250 bytes a node, and the loads, of less: all of them a
/// gigabyte.
constexpr std::size_t mostKept = 4'000'000;

void requireMemory(std::size_t splits, std::size_t nodeCount, const Scene& scene) {
    std::size_t kept = 1 + nodeCount + scene.forces.size();
    for (const NodeMove& move : scene.moves)
        kept += 1 + move.path.size();
    for (const InstrumentMotion& instrument : scene.instruments)
        kept += 1 + instrument.path.size();
    if (splits > mostKept / kept)
        throw InvalidModel("split: " + std::to_string(splits) +
                           " splits are more than a run of this organ and its loads can hold, " +
                           std::to_string(mostKept / kept) +
                           "; join paths of the same time into longer ones");
}

/// A force that acts already acts on tissue, which goes on to both sides: shared by area, as the mass is, it
/// accelerates both as it did the one.
void shareForces(Scene& scene, double time, const PartedNode& parted) {
    const std::size_t count = scene.forces.size();
    for (std::size_t i = 0; i < count; ++i) {
        NodeForce& force = scene.forces[i];
        if (force.node != parted.node || !(force.from < time)) continue;
        NodeForce onTwin = force;
        onTwin.node = parted.twin;
        onTwin.force *= parted.twinShare;
        force.force -= onTwin.force;
        scene.forces.push_back(onTwin);
    }
}

/// What leads a node has hold of all of it.
void leadTwin(Scene& scene, const PartedNode& parted) {
    const auto isOf = [](std::uint32_t node) {
        return [node](const NodeMove& move) { return move.node == node; };
    };
    const auto ofNode = std::find_if(scene.moves.begin(), scene.moves.end(), isOf(parted.node));
    if (ofNode == scene.moves.end() || std::any_of(scene.moves.begin(), scene.moves.end(), isOf(parted.twin)))
        return;
    scene.moves.push_back(NodeMove{parted.twin, ofNode->path});
}

Scene afterSplit(Scene scene, double time, const std::vector<PartedNode>& partedNodes) {
    for (const PartedNode& parted : partedNodes) {
        shareForces(scene, time, parted);
        leadTwin(scene, parted);
    }
    return scene;
}

SplitTissue splitOf(const Scene& scene, std::size_t split, const Topology& topology,
                    const TissueModel& tissue) {
    try {
        return splitAlong(topology, tissue, scene.splits[split].edges);
    } catch (const InvalidModel& error) {
        throw InvalidModel(sceneEntry("split", split) + ": " + error.what());
    }
}

/// Only once all splits are made it is known which nodes there are. validate() without them had to allow as
/// many as there may be at most.
void requireNodes(const Scene& unsplit, std::size_t nodeCount) {
    if (auto problems = validate(unsplit, nodeCount); !problems.empty())
        throw InvalidModel(std::move(problems));
}

} // namespace

// All stages are made before the run begins. A split that cannot be made is then told at once, and not after
// minutes of stepping; the step can be chosen for all of them; and runs in other steps part the organ alike.
std::vector<SceneStage> laterStages(const Topology& start, const TissueModel& tissue, const Scene& scene) {
    std::vector<SceneStage> stages;
    if (scene.splits.empty()) return stages;
    const std::vector<std::size_t> order = inOrderOfTime(scene);
    requireMemory(order.size(), tissue.mass.size(), scene);
    stages.reserve(order.size());
    Scene unsplit = scene;
    unsplit.splits.clear();
    for (const std::size_t split : order) {
        const SceneStage* before = stages.empty() ? nullptr : &stages.back();
        const double time = scene.splits[split].time;
        SplitTissue organ = splitOf(scene, split, before ? before->organ.topology : start,
                                    before ? before->organ.tissue : tissue);
        Scene after = afterSplit(before ? before->scene : unsplit, time, organ.parted);
        stages.push_back({time, split, std::move(organ), std::move(after)});
    }
    requireNodes(unsplit, stages.empty() ? tissue.mass.size() : stages.back().organ.tissue.mass.size());
    return stages;
}

// Each split adds a node at least, so that their number tells the stage.
const SceneStage* stageOfNodes(const std::vector<SceneStage>& stages, std::size_t nodeCount) {
    const auto found = std::find_if(stages.begin(), stages.end(), [&](const SceneStage& stage) {
        return stage.organ.tissue.mass.size() == nodeCount;
    });
    return found == stages.end() ? nullptr : &*found;
}

std::optional<std::vector<std::uint32_t>> recordedNodes(const Scene& scene, std::size_t nodeCount) {
    std::optional<std::vector<std::uint32_t>> nodes = scene.record.nodes;
    if (!nodes) return nodes;
    const auto made = std::stable_partition(nodes->begin(), nodes->end(),
                                            [&](std::uint32_t node) { return node < nodeCount; });
    std::sort(made, nodes->end());
    return nodes;
}

} // namespace esm
