#pragma once

#include "core/support/shared_progress.h"

#include <cstddef>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace esm {

/// Calls `work(i)` for all i below `count` on all threads, in blocks of which a free thread takes the next.
/// What one call writes no other may read or write, so that the result does not depend on the threads.
/// @throws what `work` throws, and Cancelled where a block's progress is
template<typename Work>
void forEachInBlocks(std::size_t count, std::size_t block, const Progress& progress, const Work& work) {
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

/// The same for work that takes long, one by one.
template<typename Work>
void forEachInParallel(std::size_t count, const Progress& progress, const Work& work) {
    forEachInBlocks(count, 1, progress, work);
}

} // namespace esm
