#include "core/decoding/decoder_process.h"

#include "core/decoding/decoder_program.h"
#include "core/support/child_process.h"
#include "core/support/errors.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <sys/mman.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace esm {

// Files without names carry bytes in and out of the process: nothing blocks halfway as a pipe would, and what
// came out is only looked at when the process has ended.

namespace {

[[noreturn]] void failToStart(const DecodingTask& task, int reason) {
    // Files in memory count as files.
    const char* const advice =
        reason == EFBIG ? "raise the limit on file sizes (ulimit -f)" : "close other programs and try again";
    throw FileError(task.subject,
                    std::string("cannot be decoded, because no process for it could be started: ") +
                        std::strerror(reason) + "; " + advice);
}

/// A file in memory.
Descriptor namelessFile(const DecodingTask& task) {
    const Descriptor first(::memfd_create("esm-decode", MFD_CLOEXEC));
    if (first.number() < 0) failToStart(task, errno);
    Descriptor file = beyondStandardFiles(first);
    if (file.number() < 0) failToStart(task, errno);
    return file;
}

Descriptor inputOf(const DecodingTask& task) {
    Descriptor file = namelessFile(task);
    if (!task.input) return file;
    DecodedWriter writer(file.number());
    try {
        writer.array(task.input->data(), task.input->size());
        writer.finish();
    } catch (const std::runtime_error&) {
        failToStart(task, errno);
    }
    if (::lseek(file.number(), 0, SEEK_SET) != 0) failToStart(task, errno);
    return file;
}

ChildProcess start(const DecodingTask& task, int input, int output) {
    std::vector<std::string> words = asArguments(task.limits);
    words.insert(words.begin(), decoderProgram().string());
    words.insert(words.end(), task.arguments.begin(), task.arguments.end());
    try {
        return ChildProcess({.words = std::move(words), .input = input, .output = output});
    } catch (const std::system_error& error) {
        failToStart(task, error.code().value());
    }
}

[[noreturn]] void failFromMemory(const DecodingTask& task) {
    throw FileError(task.subject,
                    "cannot be decoded within the " + inGigabytes(task.limits.memory) +
                        " of memory that it may take; make it smaller in the program it comes from");
}

[[noreturn]] void failFromTime(const DecodingTask& task) {
    throw FileError(task.subject, "was not decoded within the " + std::to_string(task.limits.seconds) +
                                      " s that it may take; make it smaller in the program it comes from");
}

[[noreturn]] void failFromSize(const DecodingTask& task) {
    throw FileError(task.subject,
                    "becomes larger than the " + inGigabytes(task.limits.output) +
                        " that may come of it, or than the limit on file sizes (ulimit -f); make it "
                        "smaller in the program it comes from");
}

[[noreturn]] void failAsEnded(const DecodingTask& task) {
    throw FileError(task.subject,
                    "cannot be decoded: the system ended the decoder, as it does when memory runs "
                    "out; close other programs and try again, or make it smaller in the program "
                    "it comes from");
}

/// Of the time that a decoder may take, the part within which it is half done as a rule. How far it is nobody
/// knows: what is reported comes ever nearer to the end.
constexpr double usualPart = 50;

/// Processor time is bounded by the system; a process that sleeps uses none, so the clock is looked at too,
/// at four times as much for machines that do other work.
void waitFor(ChildProcess& process, const DecodingTask& task, const Progress& progress) {
    constexpr std::chrono::milliseconds moment{20};
    const double start = task.clock(), most = static_cast<double>(task.limits.seconds);
    while (!process.endsWithin(moment)) {
        const double taken = task.clock() - start;
        reportProgress(progress, taken / (taken + most / usualPart));
        if (taken > 4 * most) failFromTime(task);
    }
    reportProgress(progress, 1);
}

/// The limits on time and size end the process by signals of their own, which tell what was too large; that
/// memory was not enough it says itself. SIGKILL comes from outside: the system's way out where all memory is
/// gone.
void requireSoundEnd(int status, const DecodingTask& task) {
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) failAsEnded(task);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) failFromTime(task);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXFSZ) failFromSize(task);
    const std::string end =
        WIFSIGNALED(status) ? std::string(", \"") + ::strsignal(WTERMSIG(status)) + '"' : "";
    throw FileError(task.subject, "cannot be decoded: the decoder failed at it" + end +
                                      ", so the file may be damaged or made to do harm; export it again");
}

/// The problem as the decoder tells it, in one line.
std::string problemIn(DecodedStream& stream) {
    constexpr std::uint64_t longest = 4000;
    const auto letters = stream.array<char>(std::min(longest, stream.left()));
    std::string problem(letters.begin(), letters.end());
    std::replace_if(
        problem.begin(), problem.end(), [](char letter) { return static_cast<unsigned char>(letter) < ' '; },
        ' ');
    return problem;
}

} // namespace

/// What came out is looked at only once the process has ended: then nothing can change it between a check and
/// its use.
DecodedStream decodeApart(const DecodingTask& task, const Progress& progress) {
    Descriptor output = namelessFile(task);
    {
        const Descriptor input = inputOf(task);
        ChildProcess process = start(task, input.number(), output.number());
        waitFor(process, task, progress);
        requireSoundEnd(process.status(), task);
    }
    DecodedStream stream(task.subject, std::move(output));
    switch (stream.value<DecodingOutcome>()) {
    case DecodingOutcome::Decoded:
        return stream;
    case DecodingOutcome::NoMemory:
        failFromMemory(task);
    case DecodingOutcome::Problem:
        throw FileError(task.subject, problemIn(stream));
    }
    stream.failAsNonsense();
}

} // namespace esm
