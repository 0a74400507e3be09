#pragma once

#include "core/support/file_io.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace esm {

template<typename T>
using BitsOf = std::conditional_t<sizeof(T) == 8, std::uint64_t,
                                  std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint16_t>>;

/// Appends the bits of a number, the least significant byte first, whatever the machine's own order.
template<typename T> void appendLittleEndian(Bytes& bytes, T value) {
    BitsOf<T> bits;
    std::memcpy(&bits, &value, sizeof bits);
    for (std::size_t i = 0; i < sizeof bits; ++i)
        bytes.push_back(static_cast<std::uint8_t>(bits >> (8 * i)));
}

/// Precondition: sizeof(T) bytes can be read from `bytes`.
template<typename T> T littleEndian(const std::uint8_t* bytes) {
    BitsOf<T> bits = 0;
    for (std::size_t i = 0; i < sizeof bits; ++i)
        bits |= static_cast<BitsOf<T>>(bytes[i]) << (8 * i);
    T value;
    std::memcpy(&value, &bits, sizeof bits);
    return value;
}

} // namespace esm
