#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>

namespace esm {

/// Tells a file from what takes its place under the same name, and from itself once it was written to.
struct FileVersion {
    dev_t device = 0;
    ino_t inode = 0;
    off_t size = 0;
    std::int64_t modified = 0; ///< ns

    bool operator==(const FileVersion&) const = default;
};

/// Nothing where there is no such file.
std::optional<FileVersion> versionOf(const std::filesystem::path& file);

/// Keeps other programs from replacing a file from before it is read until its successor has taken its
/// place. The system's lock on the file itself: nothing lies beside it, and it goes with the process, however
/// that ends. A file that is not there yet, that may not be written, or that lies where the system has no
/// locks is not locked; `requireUnchanged` still tells when another program came between.
class FileLock {
public:
    /// @throws FileError naming the process that has the lock, where that can be known
    explicit FileLock(const std::filesystem::path& file);
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;
    ~FileLock();

    /// To be asked right before the file is replaced. @throws FileError where it is no longer what it was
    void requireUnchanged() const;

private:
    bool isLocked() const { return m_descriptor >= 0; }
    bool tryToLock(); ///< false where it is of no use to try again
    void release();

    std::filesystem::path m_file;
    int m_descriptor = -1;
    std::optional<FileVersion> m_version; ///< as the lock was taken
};

} // namespace esm
