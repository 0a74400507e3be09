#pragma once

#include <fstream>
#include <string>
#include <sys/types.h>

namespace esm::test {

/// Whether a process is there; one that has ended may wait for its parent to hear of it.
inline bool isRunning(pid_t process) {
    std::ifstream status("/proc/" + std::to_string(process) + "/stat");
    std::string id, name, state;
    return status >> id >> name >> state && state != "Z";
}

} // namespace esm::test
