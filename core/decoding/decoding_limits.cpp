#include "core/decoding/decoding_limits.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace esm {

namespace {

constexpr std::uint64_t megabyte = 1'000'000, gigabyte = 1'000'000'000;

/// Decoding leaves the other half of the machine's memory to the program that waits for it and to all others.
std::uint64_t halfOfMemory() {
    const long pages = ::sysconf(_SC_PHYS_PAGES), pageBytes = ::sysconf(_SC_PAGESIZE);
    if (pages <= 0 || pageBytes <= 0) return 2 * gigabyte;
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(pageBytes) / 2;
}

std::uint64_t mostMemoryForMeshes() {
    return std::min(8 * gigabyte, halfOfMemory());
}

/// @param spare between what is warned of by a signal and what is refused
void limit(int resource, std::uint64_t most, std::uint64_t spare = 0) {
    const rlimit both{most, most + spare};
    ::setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

#ifdef ESM_SANITIZE
constexpr bool isWatched = true;
#else
constexpr bool isWatched = false;
#endif

} // namespace

DecodingLimits meshDecodingLimits(std::uint64_t fileBytes) {
    const std::uint64_t bytes = std::min(fileBytes, mostMeshFileBytes());
    const std::uint64_t memory = std::min(2 * gigabyte + 24 * bytes, mostMemoryForMeshes());
    return {memory, std::min(gigabyte + 4 * bytes, memory / 2), 60 + bytes / megabyte};
}

DecodingLimits largestMeshDecodingLimits() {
    return meshDecodingLimits(mostMeshFileBytes());
}

std::uint64_t mostMeshFileBytes() {
    return mostMemoryForMeshes() / 2;
}

DecodingLimits pictureDecodingLimits(std::uint64_t pixels, std::uint64_t encodedBytes) {
    const std::uint64_t memory = gigabyte + 16 * pixels + 4 * encodedBytes;
    return {std::min(memory, std::max(gigabyte, halfOfMemory())), 4 * pixels + megabyte,
            30 + pixels / megabyte};
}

/// Called in the decoder before it opens the file. First of all it is tied to the thread that waits for it: a
/// caller that crashes leaves none behind.
void holdTo(const DecodingLimits& limits) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, limits.seconds, 5); // SIGXCPU first, which tells why it ended; SIGKILL would not
    limit(RLIMIT_FSIZE, limits.output);
    if (!isWatched) limit(RLIMIT_AS, limits.memory);
}

std::vector<std::string> asArguments(const DecodingLimits& limits) {
    return {std::to_string(limits.memory), std::to_string(limits.output), std::to_string(limits.seconds)};
}

DecodingLimits limitsFromArguments(const char* const* arguments) {
    return {std::stoull(arguments[0]), std::stoull(arguments[1]), std::stoull(arguments[2])};
}

std::string inGigabytes(std::uint64_t bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f GB", static_cast<double>(bytes) / static_cast<double>(gigabyte));
    return text;
}

} // namespace esm
