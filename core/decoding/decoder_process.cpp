#include "core/decoding/decoder_process.h"

#include "core/decoding/decoder_program.h"
#include "core/support/errors.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace esm {

// A program of its own is started, not a copy of this process: after fork() in a process with threads only
// what is safe in signal handlers may be called, and the locks of Qt, TBB and of the decoders themselves may
// be held for ever by threads that the copy does not have. posix_spawn() copies no memory either, so that it
// is as fast from an editor of gigabytes. Files without names carry bytes in and out: nothing blocks halfway
// as a pipe would, and what came out is only looked at when the process has ended.

namespace {

[[noreturn]] void failToStart(const DecodingTask& task, int reason) {
    // Files in memory count as files.
    const char* const advice =
        reason == EFBIG ? "raise the limit on file sizes (ulimit -f)" : "close other programs and try again";
    throw FileError(task.subject,
                    std::string("cannot be decoded, because no process for it could be started: ") +
                        std::strerror(reason) + "; " + advice);
}

/// A file in memory. Its number is none of the standard ones, which may be free in the calling program.
Descriptor namelessFile(const DecodingTask& task) {
    const Descriptor first(::memfd_create("esm-decode", MFD_CLOEXEC));
    if (first.number() < 0) failToStart(task, errno);
    Descriptor file(::fcntl(first.number(), F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
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

/// How a new process begins: with the three standard files and nothing else of this process, no signal
/// blocked or ignored, and in a group of its own, so that Ctrl-C is the caller's to answer.
class SpawnSettings {
public:
    SpawnSettings(int input, int output) {
        ::posix_spawn_file_actions_init(&files);
        ::posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
        ::posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
        ::posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        ::posix_spawn_file_actions_addclosefrom_np(&files, STDERR_FILENO + 1);
        ::posix_spawnattr_init(&attributes);
        sigset_t none, all;
        sigemptyset(&none);
        sigfillset(&all);
        ::posix_spawnattr_setsigmask(&attributes, &none);
        ::posix_spawnattr_setsigdefault(&attributes, &all);
        ::posix_spawnattr_setpgroup(&attributes, 0);
        ::posix_spawnattr_setflags(&attributes,
                                   POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    }
    SpawnSettings(const SpawnSettings&) = delete;
    SpawnSettings& operator=(const SpawnSettings&) = delete;
    ~SpawnSettings() {
        ::posix_spawn_file_actions_destroy(&files);
        ::posix_spawnattr_destroy(&attributes);
    }

    posix_spawn_file_actions_t files{};
    posix_spawnattr_t attributes{};
};

pid_t start(const DecodingTask& task, int input, int output) {
    std::vector<std::string> words = asArguments(task.limits);
    words.insert(words.begin(), decoderProgram().string());
    words.insert(words.end(), task.arguments.begin(), task.arguments.end());
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const SpawnSettings settings(input, output);
    pid_t process = 0;
    const int reason = ::posix_spawn(&process, arguments.front(), &settings.files, &settings.attributes,
                                     arguments.data(), environ);
    if (reason != 0) failToStart(task, reason);
    return process;
}

/// A running process, ended with its owner.
class Process {
public:
    // glibc's own function lacks C linkage in Debian 12.
    explicit Process(pid_t id) : m_id(id), m_end(static_cast<int>(::syscall(SYS_pidfd_open, id, 0))) {}
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process() {
        if (m_hasEnded) return;
        ::kill(m_id, SIGKILL);
        while (::waitpid(m_id, nullptr, 0) < 0 && errno == EINTR) {
        }
    }

    /// Waits a moment, or until it has ended. Without a descriptor of the process the moment is always
    /// waited.
    bool endsWithin(std::chrono::milliseconds moment) {
        pollfd end{m_end.number(), POLLIN, 0};
        ::poll(&end, 1, static_cast<int>(moment.count()));
        int status = 0;
        const pid_t ended = ::waitpid(m_id, &status, WNOHANG);
        // A program that ignores SIGCHLD never learns how its children ended; what they left behind must do.
        m_hasEnded = ended == m_id || (ended < 0 && errno == ECHILD);
        m_status = status;
        return m_hasEnded;
    }

    int status() const { return m_status; } ///< as waitpid() gives it

private:
    pid_t m_id;
    Descriptor m_end;
    int m_status = 0;
    bool m_hasEnded = false;
};

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
void waitFor(Process& process, const DecodingTask& task, const Progress& progress) {
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
        Process process(start(task, input.number(), output.number()));
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
