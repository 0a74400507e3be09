#include "core/support/sha256.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace esm {
namespace {

Bytes bytesOf(const std::string& text) {
    return {text.begin(), text.end()};
}

/// The first three are FIPS 180-4's own examples; the others, whose last block is nearly full, are Python's.
TEST(Sha256, IsThatOfTheStandard) {
    const std::pair<std::string, const char*> known[]{
        {"abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"},
        {"abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
         "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"},
        {std::string(1'000'000, 'a'), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"},
        {"", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"},
        {std::string(55, 'a'), "9f4390f8d30c2dd92ec9f095b65e2b9ae9b0a925a5258e241c9f1e910f734318"},
        {std::string(63, 'a'), "7d3e74a05d7db15bce4ad9ec0658ea98e3f06eeecf16b4c6fff2da457ddc2f34"},
        {std::string(64, 'a'), "ffe054fe7ae0cb6dc65c3af9b61d5209f439851db43d0ba5997337df154668eb"}};
    for (const auto& [text, digits] : known)
        EXPECT_EQ(sha256Of(bytesOf(text)), digits) << text.size();
}

TEST(Sha256, CanBeStopped) {
    EXPECT_THROW(sha256Of(Bytes(1 << 20), [](double fraction) { return fraction < 0.5; }), Cancelled);
}

} // namespace
} // namespace esm
