#include "app/esmc/command_line.h"

#include <csignal>
#include <cstdio>

int main(int argc, char** argv) {
    // A limit on file sizes then shows as a write that fails, which is reported and cleaned up.
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        return esm::runCommandLine(argc, argv);
    } catch (...) {
        std::fputs("esmc: what went wrong could not even be said; most likely there is no memory left\n",
                   stderr);
        return 1;
    }
}
