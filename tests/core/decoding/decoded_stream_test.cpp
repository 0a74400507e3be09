#include "core/decoding/decoded_stream.h"

#include "core/support/errors.h"

#include <gtest/gtest.h>

#include <numeric>
#include <sys/mman.h>
#include <unistd.h>

namespace esm {
namespace {

/// A stream of what `write` wrote.
template<typename Write> DecodedStream streamOf(Write write) {
    Descriptor file(::memfd_create("test", MFD_CLOEXEC));
    DecodedWriter writer(file.number());
    write(writer);
    writer.finish();
    return {"a.ply", std::move(file)};
}

TEST(DecodedStream, GivesBackWhatWasWritten) {
    std::vector<std::uint32_t> many(1'000'000);
    std::iota(many.begin(), many.end(), 0U);
    DecodedStream stream = streamOf([&](DecodedWriter& writer) {
        writer.begin(DecodingOutcome::Decoded);
        writer.value(2.5);
        writer.array(many.data(), many.size());
        writer.value(std::uint8_t{7});
    });
    EXPECT_EQ(stream.value<DecodingOutcome>(), DecodingOutcome::Decoded);
    EXPECT_EQ(stream.value<double>(), 2.5);
    EXPECT_EQ(stream.array<std::uint32_t>(many.size()), many);
    EXPECT_EQ(stream.value<std::uint8_t>(), 7);
    EXPECT_EQ(stream.left(), 0U);
}

TEST(DecodedStream, DropsWhatWasWrittenBeforeItBeginsAnew) {
    const std::vector<char> much(3'000'000);
    DecodedStream stream = streamOf([&](DecodedWriter& writer) {
        writer.begin(DecodingOutcome::Decoded);
        writer.array(much.data(), much.size());
        writer.begin(DecodingOutcome::NoMemory);
    });
    EXPECT_EQ(stream.value<DecodingOutcome>(), DecodingOutcome::NoMemory);
    EXPECT_EQ(stream.left(), 0U);
}

TEST(DecodedStream, RefusesToGiveMoreThanThereIs) {
    DecodedStream stream = streamOf([](DecodedWriter& writer) { writer.value(std::uint32_t{5}); });
    EXPECT_THROW(stream.value<std::uint64_t>(), FileError);
    EXPECT_THROW(stream.array<std::uint8_t>(5), FileError);
    EXPECT_THROW(stream.array<double>(~std::uint64_t{0}), FileError);
    EXPECT_EQ(stream.value<std::uint32_t>(), 5U);
    EXPECT_THROW(stream.value<std::uint8_t>(), FileError);
}

} // namespace
} // namespace esm
