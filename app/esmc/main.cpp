#include "app/esmc/command_line.h"

#include <csignal>

int main(int argc, char** argv) {
    // A limit on file sizes then shows as a write that fails, which is reported and cleaned up.
    std::signal(SIGXFSZ, SIG_IGN);
    return esm::runCommandLine(argc, argv);
}
