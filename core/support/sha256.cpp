#include "core/support/sha256.h"

#include "core/support/byte_order.h"

#include <array>
#include <bit>

namespace esm {

namespace {

/// The first 32 bits behind the point of the cube roots of the first 64 primes (FIPS 180-4, 4.2.2).
constexpr std::array<std::uint32_t, 64> sha256Constants{
    0x428A2F98, 0x71374491, 0xB5C0FBCF, 0xE9B5DBA5, 0x3956C25B, 0x59F111F1, 0x923F82A4, 0xAB1C5ED5,
    0xD807AA98, 0x12835B01, 0x243185BE, 0x550C7DC3, 0x72BE5D74, 0x80DEB1FE, 0x9BDC06A7, 0xC19BF174,
    0xE49B69C1, 0xEFBE4786, 0x0FC19DC6, 0x240CA1CC, 0x2DE92C6F, 0x4A7484AA, 0x5CB0A9DC, 0x76F988DA,
    0x983E5152, 0xA831C66D, 0xB00327C8, 0xBF597FC7, 0xC6E00BF3, 0xD5A79147, 0x06CA6351, 0x14292967,
    0x27B70A85, 0x2E1B2138, 0x4D2C6DFC, 0x53380D13, 0x650A7354, 0x766A0ABB, 0x81C2C92E, 0x92722C85,
    0xA2BFE8A1, 0xA81A664B, 0xC24B8B70, 0xC76C51A3, 0xD192E819, 0xD6990624, 0xF40E3585, 0x106AA070,
    0x19A4C116, 0x1E376C08, 0x2748774C, 0x34B0BCB5, 0x391C0CB3, 0x4ED8AA4A, 0x5B9CCA4F, 0x682E6FF3,
    0x748F82EE, 0x78A5636F, 0x84C87814, 0x8CC70208, 0x90BEFFFA, 0xA4506CEB, 0xBEF9A3F7, 0xC67178F2};

constexpr std::size_t sha256Rounds = sha256Constants.size(), sha256Block = 64;

using Sha256State = std::array<std::uint32_t, 8>;

/// The message schedule (6.2.2, step 1).
std::array<std::uint32_t, sha256Rounds> sha256Schedule(const std::uint8_t* block) {
    std::array<std::uint32_t, sha256Rounds> words{};
    for (std::size_t i = 0; i < 16; ++i)
        words[i] = static_cast<std::uint32_t>(unsignedNumber(block + 4 * i, 4, ByteOrder::Big));
    for (std::size_t i = 16; i < sha256Rounds; ++i) {
        const std::uint32_t early = words[i - 15], late = words[i - 2];
        words[i] = words[i - 16] + (std::rotr(early, 7) ^ std::rotr(early, 18) ^ early >> 3) + words[i - 7] +
                   (std::rotr(late, 17) ^ std::rotr(late, 19) ^ late >> 10);
    }
    return words;
}

void addSha256Block(const std::uint8_t* block, Sha256State& state) {
    const std::array<std::uint32_t, sha256Rounds> words = sha256Schedule(block);
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t i = 0; i < sha256Rounds; ++i) {
        const std::uint32_t chosen = (e & f) ^ (~e & g), most = (a & b) ^ (a & c) ^ (b & c);
        const std::uint32_t first = h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + chosen +
                                    sha256Constants[i] + words[i];
        const std::uint32_t second = (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + most;
        h = g, g = f, f = e, e = d + first;
        d = c, c = b, b = a, a = first + second;
    }
    const Sha256State added{a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < state.size(); ++i)
        state[i] += added[i];
}

std::string sha256Digits(const Sha256State& state) {
    std::string digits;
    for (const std::uint32_t word : state)
        for (int shift = 28; shift >= 0; shift -= 4)
            digits += "0123456789abcdef"[word >> shift & 0xF];
    return digits;
}

} // namespace

std::string sha256Of(const Bytes& bytes, const Progress& progress) {
    Sha256State state{0x6A09E667, 0xBB67AE85, 0x3C6EF372, 0xA54FF53A,
                      0x510E527F, 0x9B05688C, 0x1F83D9AB, 0x5BE0CD19};
    const std::size_t whole = bytes.size() / sha256Block * sha256Block;
    for (std::size_t place = 0; place < whole; place += sha256Block) {
        reportStep(progress, place / sha256Block, whole / sha256Block);
        addSha256Block(&bytes[place], state);
    }
    reportProgress(progress, 1);
    Bytes end(bytes.begin() + static_cast<std::ptrdiff_t>(whole), bytes.end());
    end.push_back(0x80);
    while (end.size() % sha256Block != sha256Block - sizeof(std::uint64_t))
        end.push_back(0);
    for (int shift = 56; shift >= 0; shift -= 8)
        end.push_back(static_cast<std::uint8_t>(std::uint64_t{8} * bytes.size() >> shift));
    for (std::size_t place = 0; place < end.size(); place += sha256Block)
        addSha256Block(&end[place], state);
    return sha256Digits(state);
}

} // namespace esm
