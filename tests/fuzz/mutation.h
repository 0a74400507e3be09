#pragma once

#include "core/support/file_io.h"

#include <cstdint>
#include <optional>
#include <span>

namespace esm::fuzz {

/// What libFuzzer hands over to be changed: `size` bytes of a memory of `memory.size()`.
struct FuzzedInput {
    std::span<std::uint8_t> memory;
    std::size_t size;
    std::uint32_t seed;

    Bytes content() const { return {memory.begin(), memory.begin() + static_cast<std::ptrdiff_t>(size)}; }
    std::size_t mutated() const;                      ///< by libFuzzer, byte by byte. @return the new size
    std::size_t replacedBy(const Bytes& other) const; ///< mutated() where it is empty or does not fit
};

/// A part of a file by libFuzzer, or as JSON where it is some.
Bytes mutatedPart(Bytes part, std::uint32_t seed);

} // namespace esm::fuzz
