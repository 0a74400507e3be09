#pragma once

namespace esm {

/// Understands and runs one command line. Returns the exit code: 0 done, 1 the work failed, 2 wrong usage.
int runCommandLine(int argc, char** argv);

} // namespace esm
