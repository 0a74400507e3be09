#pragma once

#include "core/support/file_io.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace esm {

enum class ByteOrder { Little, Big };

/// The unsigned number in `size` bytes, at most 8. Precondition: they can be read.
inline std::uint64_t unsignedNumber(const std::uint8_t* bytes, std::size_t size, ByteOrder order) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
        value = value << 8 | bytes[order == ByteOrder::Big ? i : size - 1 - i];
    return value;
}

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
    const auto bits = static_cast<BitsOf<T>>(unsignedNumber(bytes, sizeof(T), ByteOrder::Little));
    T value;
    std::memcpy(&value, &bits, sizeof bits);
    return value;
}

} // namespace esm
