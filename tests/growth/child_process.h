#pragma once

#include <functional>
#include <string>
#include <vector>

namespace growth {

struct Usage {
    double seconds;   ///< of processor time, all threads, system calls included
    double mebibytes; ///< at most at once
};

/// Runs a program to its end; what it prints goes nowhere. @throws std::runtime_error when it fails
Usage run(const std::vector<std::string>& words);

struct Outcome {
    double result;    ///< what the work returned
    double mebibytes; ///< at most at once
};

/// Runs work of this program in a copy of it, whose memory is its own. A program that is started is told to
/// have needed as much as the one that started it, which must therefore stay small. @throws
/// std::runtime_error when it fails
Outcome runApart(const std::function<double()>& task);

} // namespace growth
