#pragma once

#include "core/model/tissue_model.h"

#include <optional>

namespace esm {

/// A node and the free ones around it at rest, within a few hundredths of the organ's size; the node first.
std::vector<std::uint32_t> graspedNodes(const TissueModel& model, std::uint32_t node);

/// A slow pull that shows an organ alive: a free node at the organ's edge, drawn outwards. Empty when every
/// node is fixed.
struct GentlePull {
    std::uint32_t node;
    Eigen::Vector3d furthest; ///< m, displacement
};
std::optional<GentlePull> gentlePull(const TissueModel& model);

/// Whether a scene has loads of its own, beside gravity: forces, led nodes or instruments.
bool hasLoads(const Scene& scene);

/// Whether something in a scene moves the tissue: a load, a led node, gravity or an instrument.
bool movesTissue(const Scene& scene);

/// The scene with a gentle pull for a second in place of its duration: the nodes grasped at the organ's edge
/// are drawn outwards and held, and every node is recorded.
/// @throws InvalidModel when every node is fixed
Scene withGentlePull(const TissueModel& model, Scene scene);

} // namespace esm
