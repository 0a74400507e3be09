#pragma once

#include "core/support/parallel_steps.h"

namespace esm {

/// Of work that is quick for each node.
template<typename Work> void forEachNode(std::size_t count, const Progress& progress, const Work& work) {
    forEachInBlocks(count, 512, progress, work);
}

} // namespace esm
