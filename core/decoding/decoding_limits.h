#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace esm {

/// What decoding one file may take before it is ended.
struct DecodingLimits {
    std::uint64_t memory = 0;  ///< bytes of address space
    std::uint64_t output = 0;  ///< bytes handed back
    std::uint64_t seconds = 0; ///< of processor time; of the clock four times as much
};

/// Generous for a mesh file of so many bytes: tens of times what importers were seen to take.
DecodingLimits meshDecodingLimits(std::uint64_t fileBytes);

/// Of a file whose numbers lie in others beside it, which are not known before it is read.
DecodingLimits largestMeshDecodingLimits();

/// Of the largest mesh file that is looked at: what is read takes its own size at the very least again.
std::uint64_t mostMeshFileBytes();

/// Generous for a picture that says it has so many pixels.
DecodingLimits pictureDecodingLimits(std::uint64_t pixels, std::uint64_t encodedBytes);

/// For the decoding program: holds itself to the limits, before it looks at a file, and ends with the thread
/// that started it, unless that ended before. Under the address sanitizer memory is not limited: its shadow
/// takes terabytes of addresses.
void holdTo(const DecodingLimits& limits);

/// The limits as the decoding program's first arguments, and back. @throws std::invalid_argument
std::vector<std::string> asArguments(const DecodingLimits& limits);
DecodingLimits limitsFromArguments(const char* const* arguments);
constexpr int limitArguments = 3;

/// "2.0 GB", for messages.
std::string inGigabytes(std::uint64_t bytes);

} // namespace esm
