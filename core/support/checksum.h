#pragma once

#include <cstddef>
#include <cstdint>

namespace esm {

/// CRC-32 as zlib, PNG and gzip have it (ISO 3309; polynomial 0x04C11DB7, its bits in reverse order). It
/// tells any damage within 32 bits that follow each other, and of other damage all but one in four thousand
/// million; not what somebody changed on purpose.
std::uint32_t checksumOf(const std::uint8_t* bytes, std::size_t size);

} // namespace esm
