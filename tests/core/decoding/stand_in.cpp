#include "core/decoding/decoded_stream.h"
#include "core/decoding/decoding_limits.h"

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <unistd.h>
#include <vector>

namespace {

using namespace esm;

void loop() {
    for (volatile bool forever = true; forever;) {
    }
}

void eatMemory() {
    std::vector<void*> eaten;
    constexpr std::size_t bite = 16 << 20;
    for (void* piece = nullptr; (piece = std::malloc(bite)) != nullptr;) {
        std::memset(piece, 1, bite);
        eaten.push_back(piece);
    }
    std::abort();
}

void writeText(const std::string& text) {
    DecodedWriter writer(STDOUT_FILENO);
    writer.array(text.data(), text.size());
    writer.finish();
}

/// A surface of four vertices that ends behind two of them.
void writeHalf() {
    DecodedWriter writer(STDOUT_FILENO);
    writer.begin(DecodingOutcome::Decoded);
    for (const std::uint64_t count : {4U, 4U, 12U})
        writer.value(count);
    for (int i = 0; i < 6; ++i)
        writer.value(double(i));
    writer.finish();
}

/// A surface whose counts claim more than any machine holds.
void writeLies() {
    DecodedWriter writer(STDOUT_FILENO);
    writer.begin(DecodingOutcome::Decoded);
    for (int i = 0; i < 3; ++i)
        writer.value(~std::uint64_t{0});
    writer.finish();
}

/// A triangle with a corner that is none of its three vertices, or without a place.
void writeTriangle(std::uint32_t lastCorner, double coordinate) {
    DecodedWriter writer(STDOUT_FILENO);
    writer.begin(DecodingOutcome::Decoded);
    for (const std::uint64_t count : {3U, 1U, 3U})
        writer.value(count);
    for (int i = 0; i < 9; ++i)
        writer.value(coordinate);
    for (const std::uint32_t number : {3U, 0U, 1U, lastCorner})
        writer.value(number);
    writer.finish();
}

void writeTooMuch() {
    DecodedWriter writer(STDOUT_FILENO);
    writer.begin(DecodingOutcome::Decoded);
    const std::vector<char> zeros(1 << 20);
    for (;;)
        writer.array(zeros.data(), zeros.size());
}

void sayProblem(const std::string& text) {
    DecodedWriter writer(STDOUT_FILENO);
    writer.begin(DecodingOutcome::Problem);
    writer.array(text.data(), text.size());
    writer.finish();
}

/// What a decoder must not have of the process that started it: open files, and signals that it waits out.
void reportInheritance() {
    sigset_t blocked;
    ::sigprocmask(SIG_BLOCK, nullptr, &blocked);
    std::string found;
    for (int descriptor = 3; descriptor < 100; ++descriptor)
        if (::lseek(descriptor, 0, SEEK_CUR) >= 0) found += " file " + std::to_string(descriptor);
    if (::sigismember(&blocked, SIGINT)) found += " blocked signal";
    if (::signal(SIGXFSZ, SIG_DFL) == SIG_IGN) found += " ignored signal";
    sayProblem("has" + (found.empty() ? " nothing" : found));
}

void act(const std::string& role, const DecodingLimits& limits) {
    if (role == "abort") std::abort();
    if (role == "crash") ::raise(SIGSEGV);
    if (role == "killed") ::raise(SIGKILL);
    if (role == "exit") ::_exit(3);
    if (role == "loop") loop();
    if (role == "sleep") ::sleep(1000);
    if (role == "eat") eatMemory();
    if (role == "nonsense") writeText("this is no result of a decoder, but a text of some length");
    if (role == "half") writeHalf();
    if (role == "lies") writeLies();
    if (role == "corner") writeTriangle(3, 1);
    if (role == "place") writeTriangle(2, 1e308 * 10);
    if (role == "long") writeTooMuch();
    if (role == "chatter") sayProblem("two\nlines\x1b[31m");
    if (role == "inheritance") reportInheritance();
    if (role == "limits") sayProblem("may take " + std::to_string(limits.memory) + " bytes");
}

} // namespace

/// Called as esm-decode; the last word's name without folder and ending says how to fail.
int main(int wordCount, char** words) {
    if (wordCount <= 1 + limitArguments) return 2;
    const DecodingLimits limits = limitsFromArguments(words + 1);
    holdTo(limits);
    act(std::filesystem::path(words[wordCount - 1]).stem().string(), limits);
    return 0;
}
