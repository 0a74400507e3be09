#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace esm {

/// Why a file cannot be written, and what to do, for an `errno`.
std::string writingProblem(int reason);

/// False, with `errno`, where not all of it could be written.
bool writeWhole(int descriptor, std::string_view data);

/// A file written piece by piece that replaces its target whole or not at all. Until commit() the target is
/// as it was; what was written goes away with the object, and on file systems that know nameless files even
/// when the process is killed. Of one that is killed in the moment between getting a name and taking the
/// target's place the whole new file stays beside the target.
class AtomicFile {
public:
    /// @throws FileError when the folder is missing or read-only, or the target is no regular file, is
    /// write-protected or is a link to nothing
    explicit AtomicFile(const std::filesystem::path& target);
    /// For a target in a folder that commit() may be the first to find: until then what is written is in
    /// another folder of the same file system.
    AtomicFile(const std::filesystem::path& target, const std::filesystem::path& unfinishedIn);
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    ~AtomicFile();

    void write(std::string_view data); ///< @throws FileError when the disk is full
    void sync();                       ///< all of it to the disk, so that commit() has little left to do
    void commit();                     ///< synced, then renamed over the target. @throws FileError

private:
    void flush();
    void writeOut(std::string_view data);
    void giveName();
    [[noreturn]] void fail() const;

    std::filesystem::path m_file;   ///< as the caller named it, for messages
    std::filesystem::path m_target; ///< with symbolic links resolved
    std::string m_name;             ///< of the unfinished file; empty while it has none
    std::string m_buffer;
    int m_descriptor = -1;
};

} // namespace esm
