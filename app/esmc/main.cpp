#include "app/esmc/command_line.h"

#include <csignal>

// What could escape is a fault of the program itself, best seen where it happens.
int main(int argc, char** argv) { // NOLINT(bugprone-exception-escape)
    // A limit on file sizes then shows as a write that fails, which is reported and cleaned up.
    std::signal(SIGXFSZ, SIG_IGN);
    return esm::runCommandLine(argc, argv);
}
