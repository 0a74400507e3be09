#pragma once

#include <cstdlib>
#include <filesystem>

/// Names another program as the one that decodes, as long as it lives.
class DecodeWith {
public:
    explicit DecodeWith(const std::filesystem::path& program) { ::setenv("ESM_DECODE", program.c_str(), 1); }
    DecodeWith(const DecodeWith&) = delete;
    DecodeWith& operator=(const DecodeWith&) = delete;
    ~DecodeWith() { ::unsetenv("ESM_DECODE"); }
};

/// The program that fails in every way that a decoder may; the name of its file says in which.
inline std::filesystem::path failingDecoder() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "decoding_stand_in";
}
