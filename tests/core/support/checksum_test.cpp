#include "core/support/checksum.h"

#include "core/support/file_io.h"

#include <gtest/gtest.h>

#include <random>
#include <zlib.h>

namespace esm {
namespace {

TEST(Checksum, IsZlibs) {
    std::mt19937 random(1);
    for (std::size_t size = 0; size < 200; ++size) {
        Bytes bytes(size + 8);
        for (std::uint8_t& byte : bytes)
            byte = static_cast<std::uint8_t>(random());
        for (std::size_t begin = 0; begin < 8; ++begin)
            EXPECT_EQ(checksumOf(&bytes[begin], size), crc32_z(0, &bytes[begin], size)) << size;
    }
}

TEST(Checksum, TellsEveryFlippedBit) {
    Bytes bytes(64, 0xA5);
    const std::uint32_t whole = checksumOf(bytes.data(), bytes.size());
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        const auto flipped = static_cast<std::uint8_t>(1U << bit % 8);
        bytes[bit / 8] ^= flipped;
        EXPECT_NE(checksumOf(bytes.data(), bytes.size()), whole) << bit;
        bytes[bit / 8] ^= flipped;
    }
}

} // namespace
} // namespace esm
