#pragma once

#include "core/dynamics/kernel/slice_layout.h"

#include <vector>

namespace esm {

/// Where hinges are in the kernel's blocks, and where each row finds what they do to it. A hinge is computed
/// once: at each of its four nodes, as springs are at both of theirs, would cost more than the way through
/// memory that its forces take to the nodes' sums. Rows sum up in an order that never changes.
struct HingeLayout {
    std::vector<std::uint32_t> order; ///< of the system's hinges
    LargeVector<kernel::HingeNodes> nodes;
    std::vector<std::uint32_t> starts; ///< of each slice, its first column of places, and the end
    LargeVector<kernel::ForcePlaces> places;

    std::size_t blockCount() const { return nodes.size(); }
    /// Places behind the last are of the one that is no force.
    std::size_t forceCount() const { return 4 * kernel::sliceHeight * blockCount() + 1; }
};

/// @param recordSize bytes of one node's record
/// @throws InvalidModel where there are more hinges than numbers for them
HingeLayout makeHingeLayout(const SpringSystem& system, const SliceLayout& slices, std::size_t recordSize);

} // namespace esm
