#include "core/dynamics/kernel/large_pages.h"

#include <cstdlib>
#include <new>
#include <sys/mman.h>

namespace esm {

namespace {

constexpr std::size_t cacheLine = 64, largePage = 2 << 20;

std::size_t roundedUp(std::size_t bytes, std::size_t unit) {
    return (bytes + unit - 1) / unit * unit;
}

} // namespace

// A step of large tissue walks through all of it, and springs reach to places far apart. With pages of 4 kB,
// of 64 records each, the processor would often have to look up where a page lies; pages of 2 MB are few
// enough to be known. Blocks of less than two of them would be rounded up by too large a part of themselves.
void* allocateOnLargePages(std::size_t bytes) {
    const std::size_t alignment = bytes < 2 * largePage ? cacheLine : largePage;
    void* const memory = std::aligned_alloc(alignment, roundedUp(bytes, alignment));
    if (!memory) throw std::bad_alloc();
    // Where there are none, nothing is lost.
    if (alignment == largePage) madvise(memory, roundedUp(bytes, largePage), MADV_HUGEPAGE);
    return memory;
}

void freeOnLargePages(void* memory) {
    std::free(memory);
}

} // namespace esm
