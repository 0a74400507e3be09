#pragma once

#include <filesystem>
#include <string_view>

namespace esm {

/// A file to whose end is written, piece by piece, each of which outlives the machine once it is synced.
class AppendedFile {
public:
    /// @throws FileError where the file is not there or may not be written
    explicit AppendedFile(const std::filesystem::path& file);
    AppendedFile(const AppendedFile&) = delete;
    AppendedFile& operator=(const AppendedFile&) = delete;
    ~AppendedFile();

    void append(std::string_view data); ///< @throws FileError when the disk is full
    void sync();                        ///< @throws FileError

private:
    [[noreturn]] void fail() const;

    std::filesystem::path m_file;
    int m_descriptor = -1;
};

/// What was made or renamed in a folder then outlives the machine. @throws FileError
void syncFolder(const std::filesystem::path& folder);

} // namespace esm
