#pragma once

#include "core/support/shared_progress.h"

#include <cstddef>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace esm {

/// Calls `work(i)` for all i below `count` on all threads, a block at a time. What one call writes no other
/// may read or write, so that the result does not depend on the threads.
/// @param block how many a thread takes at once: of long works few
/// @throws Cancelled where the progress asks to stop
template<typename Work>
void forEachNode(std::size_t count, const Progress& progress, const Work& work, std::size_t block = 512) {
    SharedProgress shared(progress, count);
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, block),
        [&](const tbb::blocked_range<std::size_t>& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i)
                work(i);
            shared.add(range.size());
        },
        tbb::simple_partitioner());
}

} // namespace esm
