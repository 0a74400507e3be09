#pragma once

#include <cstdint>

namespace benchmarks {

/// The memory that the process takes at most, beyond what it had when this was made. Linux only.
class MemoryPeak {
public:
    MemoryPeak();
    std::int64_t bytes() const; ///< 0 where the system does not tell

private:
    std::int64_t m_before;
};

} // namespace benchmarks
