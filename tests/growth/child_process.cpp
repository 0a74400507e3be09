#include "tests/growth/child_process.h"

#include <fcntl.h>
#include <iostream>
#include <spawn.h>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace growth {

namespace {

double inSeconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

pid_t start(std::vector<std::string> words) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    const int problem = posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (problem != 0) throw std::runtime_error("cannot start " + words[0]);
    return child;
}

Usage usageOf(pid_t child, const std::string& what) {
    int status = 0;
    rusage usage{};
    if (wait4(child, &status, 0, &usage) != child || status != 0) throw std::runtime_error(what + " failed");
    return {inSeconds(usage.ru_utime) + inSeconds(usage.ru_stime),
            static_cast<double>(usage.ru_maxrss) / 1024};
}

/// Ends the process.
[[noreturn]] void tellResult(const std::function<double()>& task, int pipeEnd) {
    int status = 1;
    try {
        const double result = task();
        status = write(pipeEnd, &result, sizeof result) == sizeof result ? 0 : 1;
    } catch (const std::exception& problem) {
        std::cerr << problem.what() << '\n';
    }
    _exit(status);
}

} // namespace

Usage run(const std::vector<std::string>& words) {
    return usageOf(start(words), words[0] + " " + words[1]);
}

Outcome runApart(const std::function<double()>& task) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child == 0) tellResult(task, ends[1]);
    close(ends[1]);
    double result = 0;
    const bool isTold = read(ends[0], &result, sizeof result) == sizeof result;
    close(ends[0]);
    const Usage usage = usageOf(child, "work of this program");
    if (!isTold) throw std::runtime_error("work of this program has no result");
    return {result, usage.mebibytes};
}

} // namespace growth
