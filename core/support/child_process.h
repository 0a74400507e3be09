#pragma once

#include "core/support/descriptor.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace esm {

/// A program to be started.
struct ChildProgram {
    std::vector<std::string> words; ///< where it is, then what it is told
    /// Descriptors beyond the standard ones that become its standard files; -1: nothing comes from there, or
    /// is lost there.
    int input = -1, output = -1, errors = -1;
};

/// A running program, ended with its owner, and with it all that it has started in its group.
class ChildProcess {
public:
    /// @throws std::system_error where it cannot be started
    explicit ChildProcess(const ChildProgram& program);
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;
    ~ChildProcess();

    /// Waits until the program has ended, at most so long; whether it has. What is left of its group ends
    /// then. Without a descriptor of the process all of the time is waited.
    bool endsWithin(std::chrono::milliseconds moment);

    int status() const { return m_status; } ///< as waitpid() gives it

private:
    void endGroup();

    pid_t m_id;
    Descriptor m_end;
    int m_status = 0;
    bool m_hasEnded = false;
};

/// The same file under a number that is none of the standard ones, which may be free in this program; none,
/// with `errno`, where there is no other.
Descriptor beyondStandardFiles(const Descriptor& file);

/// Whether a file is a program that this user may run.
bool canBeRun(const std::filesystem::path& program);

/// Where the first program of a name is on the PATH.
std::optional<std::filesystem::path> programInPath(const std::string& name);

} // namespace esm
