#pragma once

#include <cstddef>
#include <vector>

namespace esm {

/// Memory on pages of 2 MB where it is large and the system has such: a walk through it then waits less for
/// addresses. Aligned to cache lines. @throws std::bad_alloc
void* allocateOnLargePages(std::size_t bytes);
void freeOnLargePages(void* memory);

template<class T> struct LargePageAllocator {
    using value_type = T;

    LargePageAllocator() = default;
    template<class Other> LargePageAllocator(const LargePageAllocator<Other>&) {}

    T* allocate(std::size_t count) { return static_cast<T*>(allocateOnLargePages(count * sizeof(T))); }
    void deallocate(T* memory, std::size_t) { freeOnLargePages(memory); }

    friend bool operator==(LargePageAllocator, LargePageAllocator) { return true; }
    friend bool operator!=(LargePageAllocator, LargePageAllocator) { return false; }
};

template<class T> using LargeVector = std::vector<T, LargePageAllocator<T>>;

} // namespace esm
