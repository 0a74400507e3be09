#pragma once

#include "core/decoding/decoded_stream.h"
#include "core/decoding/decoding_limits.h"
#include "core/support/errors.h"

#include <cstdio>
#include <exception>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace esm {

/// All of the standard input, a file, as it lies in memory until the process ends: not copied once more.
inline std::span<const std::uint8_t> standardInput() {
    struct stat status {};
    if (::fstat(STDIN_FILENO, &status) != 0) throw std::runtime_error("nothing to decode");
    const auto size = static_cast<std::size_t>(status.st_size);
    if (size == 0) return {};
    void* const begin = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, STDIN_FILENO, 0);
    if (begin == MAP_FAILED) throw std::bad_alloc();
    return {static_cast<const std::uint8_t*>(begin), size};
}

inline void sayProblem(const std::string& problem, DecodedWriter& writer) {
    writer.begin(DecodingOutcome::Problem);
    writer.array(problem.data(), problem.size());
    writer.finish();
}

/// Lets `decode` write to the standard output, a file, what it makes of the words behind the limits.
/// @return for the process to end with at once: 0 when something was written, a problem too
template<typename Decode> int decodingMain(int wordCount, char** words, Decode decode) {
    if (wordCount <= 1 + limitArguments) {
        std::fputs("started by esm and esmc to decode a file for them, not by people\n", stderr);
        return 2;
    }
    DecodedWriter writer(STDOUT_FILENO);
    try {
        holdTo(limitsFromArguments(words + 1));
        try {
            decode(words, writer);
            writer.finish();
        } catch (const std::bad_alloc&) {
            writer.begin(DecodingOutcome::NoMemory);
            writer.finish();
        } catch (const std::exception& error) {
            sayProblem(error.what(), writer);
        }
    } catch (const std::exception&) {
        return 1;
    }
    return 0;
}

/// @param image as it is to be shown but for being turned upright
inline void writePicture(std::uint32_t width, std::uint32_t height, const std::uint8_t* pixels,
                         DecodedWriter& writer) {
    writer.begin(DecodingOutcome::Decoded);
    writer.value(width);
    writer.value(height);
    writer.array(pixels, 4 * std::size_t{width} * height);
}

constexpr const char* undecodablePicture =
    "is damaged or of a rare kind and cannot be decoded; save it as PNG or JPEG again";

} // namespace esm
