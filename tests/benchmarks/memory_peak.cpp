#include "tests/benchmarks/memory_peak.h"

#include <fstream>
#include <malloc.h>
#include <string>

namespace benchmarks {

namespace {

/// Of /proc/self/status, bytes.
std::int64_t statusOf(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.compare(0, key.size(), key) == 0) return 1024 * std::stoll(line.substr(key.size()));
    return 0;
}

} // namespace

MemoryPeak::MemoryPeak() {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5; // the peak is what is there now
    m_before = statusOf("VmRSS:");
}

std::int64_t MemoryPeak::bytes() const {
    return statusOf("VmHWM:") - m_before;
}

} // namespace benchmarks
