#pragma once

#include "core/dynamics/kernel/large_pages.h"
#include "core/dynamics/kernel/slice_kernel.h"
#include "core/dynamics/spring_system.h"

namespace esm {

/// Where nodes and springs are in the kernel's slices (sliced ELLPACK). Every spring is in two rows, those of
/// both its ends: each row is summed up by itself, in an order that never changes.
struct SliceLayout {
    struct Entries {
        std::uint32_t first, second; ///< column · sliceHeight + row within the slice
    };

    std::vector<std::uint32_t> rowOfNode;
    std::vector<std::uint32_t> starts; ///< first column of each slice, and the end
    LargeVector<kernel::Neighbours> neighbours;
    std::vector<Entries> entries; ///< of each spring

    std::size_t sliceCount() const { return starts.size() - 1; }
    std::size_t rowCount() const { return sliceCount() * kernel::sliceHeight; }
};

/// `recordSize` are the bytes of one node's record.
/// @throws InvalidModel when there are more nodes than offsets can reach (67 million)
SliceLayout makeSliceLayout(const SpringSystem& system, std::size_t recordSize);

} // namespace esm
