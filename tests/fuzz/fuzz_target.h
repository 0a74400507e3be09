#pragma once

#include "core/support/file_io.h"

#include <cstdint>
#include <string_view>

/// A fuzz target reads one kind of file, whatever its bytes say. Each is a program of one source that defines
/// readInput(), and of `fuzz_target.cpp`, which libFuzzer calls with ever other bytes.
namespace esm::fuzz {

/// Reads the content of a file. It may be refused with words, by FileError or InvalidModel. All else
/// that happens is a finding.
void readInput(const Bytes& content);

/// Ends the program, which libFuzzer takes for a finding, where what has to hold does not.
void expect(bool holds, std::string_view what);

/// A file without a name that lies in memory.
class FileInMemory {
public:
    explicit FileInMemory(const Bytes& content);
    FileInMemory(const FileInMemory&) = delete;
    FileInMemory& operator=(const FileInMemory&) = delete;
    ~FileInMemory();

    std::filesystem::path path() const; ///< by which this process can open it

private:
    int m_descriptor;
};

} // namespace esm::fuzz

/// libFuzzer's own mutation. @return the new size, at most `most`
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);
