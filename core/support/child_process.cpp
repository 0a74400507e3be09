#include "core/support/child_process.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sstream>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <system_error>

namespace esm {

// A program of its own is started, not a copy of this process: after fork() in a process with threads only
// what is safe in signal handlers may be called, and locks of Qt, TBB and other libraries may be held for
// ever by threads that the copy does not have. posix_spawn() copies no memory either, so that it is as fast
// from an editor of gigabytes.

namespace fs = std::filesystem;

namespace {

/// How a new process begins: with the three standard files and nothing else of this process, no signal
/// blocked or ignored, and in a group of its own, so that Ctrl-C is the caller's to answer.
class SpawnSettings {
public:
    explicit SpawnSettings(const ChildProgram& program) {
        ::posix_spawn_file_actions_init(&files);
        give(program.input, STDIN_FILENO, O_RDONLY);
        give(program.output, STDOUT_FILENO, O_WRONLY);
        give(program.errors, STDERR_FILENO, O_WRONLY);
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

private:
    void give(int descriptor, int number, int access) {
        if (descriptor >= 0)
            ::posix_spawn_file_actions_adddup2(&files, descriptor, number);
        else
            ::posix_spawn_file_actions_addopen(&files, number, "/dev/null", access, 0);
    }
};

pid_t startedProcess(const ChildProgram& program) {
    std::vector<std::string> words = program.words;
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const SpawnSettings settings(program);
    pid_t process = 0;
    const int reason = ::posix_spawn(&process, arguments.front(), &settings.files, &settings.attributes,
                                     arguments.data(), environ);
    if (reason != 0) throw std::system_error(reason, std::generic_category());
    return process;
}

} // namespace

// glibc's own function for a descriptor of a process lacks C linkage in Debian 12.
ChildProcess::ChildProcess(const ChildProgram& program)
    : m_id(startedProcess(program)), m_end(static_cast<int>(::syscall(SYS_pidfd_open, m_id, 0))) {}

ChildProcess::~ChildProcess() {
    endGroup();
}

/// The number of a process that has ended stays its own until it is waited for, so that no other group has
/// it.
void ChildProcess::endGroup() {
    if (m_hasEnded) return;
    ::kill(-m_id, SIGKILL);
    while (::waitpid(m_id, &m_status, 0) < 0 && errno == EINTR) {
    }
    m_hasEnded = true;
}

bool ChildProcess::endsWithin(std::chrono::milliseconds moment) {
    if (m_hasEnded) return true;
    pollfd end{m_end.number(), POLLIN, 0};
    ::poll(&end, 1, static_cast<int>(moment.count()));
    siginfo_t ended{};
    const int result = ::waitid(P_PID, static_cast<id_t>(m_id), &ended, WEXITED | WNOHANG | WNOWAIT);
    // A program that ignores SIGCHLD never learns how its children ended; what they left behind must do.
    const bool isUnknown = result < 0 && errno == ECHILD;
    if (ended.si_pid == m_id || isUnknown) endGroup();
    return m_hasEnded;
}

Descriptor beyondStandardFiles(const Descriptor& file) {
    return Descriptor(::fcntl(file.number(), F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
}

bool canBeRun(const fs::path& program) {
    std::error_code error;
    return fs::is_regular_file(program, error) && ::access(program.c_str(), X_OK) == 0;
}

std::optional<fs::path> programInPath(const std::string& name) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (!folder.empty() && canBeRun(fs::path(folder) / name)) return fs::path(folder) / name;
    return std::nullopt;
}

} // namespace esm
