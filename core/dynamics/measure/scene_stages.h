#pragma once

#include "core/model/scene.h"
#include "core/model/surface_split.h"

namespace esm {

/// A part of a scene's run that begins with a split, and goes on with what that leaves.
struct SceneStage {
    double begin;      ///< s
    std::size_t split; ///< its place in the scene's list
    SplitTissue organ; ///< with the way there from the stage before
    Scene scene;       ///< what acts from then on
};

/// What follows the first stage of a scene, by time, then in the order of its splits; none without splits.
/// Forces that begin before a split go on with both parts of a node, shared by area. What leads a node leads
/// both, but where the new one has a path of its own. What begins later acts on the nodes that it names.
/// Splits at the scene's end or later do not happen.
/// @param start with the surface that is split, drawn or simulated
/// @throws InvalidModel with the entry of the scene, where a split cannot be made, or something names a node
/// that no split makes; where there are more splits than memory holds organs
std::vector<SceneStage> laterStages(const Topology& start, const TissueModel& tissue, const Scene& scene);

/// The stage of so many nodes, which no two have; null: the scene's start, or none.
const SceneStage* stageOfNodes(const std::vector<SceneStage>& stages, std::size_t nodeCount);

/// The nodes that a scene records, in the order in which they are recorded: those that splits make come after
/// the first `nodeCount`, which were there at the start. None: all.
std::optional<std::vector<std::uint32_t>> recordedNodes(const Scene& scene, std::size_t nodeCount);

} // namespace esm
