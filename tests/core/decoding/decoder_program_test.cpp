#include "core/decoding/decoder_program.h"

#include "core/support/errors.h"
#include "tests/support/decode_with.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

namespace fs = std::filesystem;

TEST(DecoderProgram, LiesBesideTheRunningOne) {
    EXPECT_TRUE(
        fs::equivalent(decoderProgram(), fs::read_symlink("/proc/self/exe").parent_path() / "esm-decode"));
}

TEST(DecoderProgram, IsWhatTheEnvironmentNames) {
    const DecodeWith standIn(failingDecoder());
    EXPECT_EQ(decoderProgram(), failingDecoder());
}

TEST(DecoderProgram, IsNoOtherThanTheEnvironmentNames) {
    for (const char* named : {"/nowhere/esm-decode", "/", "/etc/passwd"}) {
        const DecodeWith wrong(named);
        try {
            decoderProgram();
            ADD_FAILURE() << named;
        } catch (const FileError& error) {
            EXPECT_THAT(error.what(),
                        testing::AllOf(testing::HasSubstr(named), testing::HasSubstr("ESM_DECODE")));
        }
    }
}

} // namespace
} // namespace esm
