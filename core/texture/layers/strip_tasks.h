#pragma once

#include "core/support/progress.h"

#include <algorithm>
#include <cstddef>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace esm {

/// Calls `work(i)` for all strips on all threads, whichever is free taking the next, and reports progress
/// from the calling thread.
/// @throws Cancelled
template<typename Work> void forEachStrip(std::size_t strips, const Progress& progress, const Work& work) {
    constexpr std::size_t perReport = 32;
    for (std::size_t first = 0; first < strips; first += perReport) {
        reportProgress(progress, static_cast<double>(first) / static_cast<double>(strips));
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(first, std::min(first + perReport, strips), 1),
            [&](const tbb::blocked_range<std::size_t>& range) {
                for (std::size_t i = range.begin(); i < range.end(); ++i)
                    work(i);
            },
            tbb::simple_partitioner());
    }
}

} // namespace esm
