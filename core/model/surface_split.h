#pragma once

#include "core/model/tissue_model.h"
#include "core/model/topology.h"

namespace esm {

/// A node that became two.
struct PartedNode {
    std::uint32_t node, twin; ///< what lies on the left of the path keeps the number
    double twinShare;         ///< 0 to 1: of mass, tethers and forces, the area that went with the twin
};

/// An organ after a split, with what the run needs to go on in it.
struct SplitTissue {
    Topology topology;
    TissueModel tissue;
    NodeMap map; ///< from the nodes before
    std::vector<PartedNode> parted;
};

/// Parts the surface along a chain or a loop of edges of the simulated surface, in order. Nodes inside a
/// chain become two, an end that lies on the border too, at a loop all. The side on the left of the path,
/// seen from outside, keeps the numbers; new nodes are numbered along the path. Mass and tethers are shared
/// by the area at rest on either side; both of a fixed node are fixed. A spring along the path becomes two of
/// half its constant and half its viscosity; a hinge along it is gone. The moment it is made it changes
/// neither motion nor energy, but for what such hinges held.
/// @throws InvalidModel where the path is none, touches itself or the border on its way, parts nothing, or
/// the surface around it has no two sides; where fewer nodes carry the drawn surface; where a spring that is
/// no edge of the surface would have no side; where it opens a part that is filled
SplitTissue splitAlong(const Topology& topology, const TissueModel& tissue, const EdgePath& path);

} // namespace esm
