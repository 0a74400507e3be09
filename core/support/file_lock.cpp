#include "core/support/file_lock.h"

#include "core/support/errors.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>

namespace esm {

namespace fs = std::filesystem;

namespace {

FileVersion versionFrom(const struct stat& status) {
    constexpr std::int64_t nanoseconds = 1'000'000'000;
    return {status.st_dev, status.st_ino, status.st_size,
            status.st_mtim.tv_sec * nanoseconds + status.st_mtim.tv_nsec};
}

std::optional<FileVersion> versionOf(int descriptor) {
    struct stat status {};
    if (::fstat(descriptor, &status) != 0) return std::nullopt;
    return versionFrom(status);
}

bool isSameFile(const std::optional<FileVersion>& a, const std::optional<FileVersion>& b) {
    return a && b && a->device == b->device && a->inode == b->inode;
}

/// As far as it can be read: what the system says of an open file ends when that is closed.
std::string contentOf(const fs::path& file) {
    std::ostringstream content;
    content << std::ifstream(file).rdbuf(); // unlike the buffer's own iterators, this does not throw
    return content.str();
}

bool isNumber(const std::string& text) {
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// As far as they can be listed: processes and their files go while one looks.
std::vector<fs::path> entriesOf(const fs::path& folder) {
    std::vector<fs::path> entries;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error))
        entries.push_back(entry->path());
    return entries;
}

/// Whether one of a process's open files is this one, with a lock on it.
bool holds(const fs::path& process, const FileVersion& file) {
    const std::vector<fs::path> open = entriesOf(process / "fd");
    return std::any_of(open.begin(), open.end(), [&](const fs::path& entry) {
        struct stat status {};
        return ::stat(entry.c_str(), &status) == 0 && status.st_dev == file.device &&
               status.st_ino == file.inode &&
               contentOf(process / "fdinfo" / entry.filename()).find("lock:") != std::string::npos;
    });
}

/// "process 123 (esmc tissue liver.esm)": the system names no holder of such a lock, but lets a user look
/// through the open files of his own processes.
std::string holderOf(const FileVersion& file) {
    for (const fs::path& process : entriesOf("/proc")) {
        const std::string number = process.filename().string();
        if (!isNumber(number) || !holds(process, file)) continue;
        std::string command = contentOf(process / "cmdline");
        while (!command.empty() && command.back() == '\0')
            command.pop_back();
        if (command.empty()) break; // it has ended
        std::replace(command.begin(), command.end(), '\0', ' ');
        return "process " + number + " (" + command + ")";
    }
    return "another process";
}

enum class Lock { Taken, HeldByOther, Impossible };

/// Of the open file, not of the process, which would lose it when another part of it reads the file. One byte
/// beyond any content: some network file systems let no one read what is locked.
Lock lock(int descriptor) {
    struct flock range {};
    range.l_type = F_WRLCK;
    range.l_whence = SEEK_SET;
    range.l_start = off_t{1} << 62;
    range.l_len = 1;
    if (::fcntl(descriptor, F_OFD_SETLK, &range) == 0) return Lock::Taken;
    return errno == EAGAIN || errno == EACCES ? Lock::HeldByOther : Lock::Impossible;
}

} // namespace

std::optional<FileVersion> versionOf(const fs::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return std::nullopt;
    return versionFrom(status);
}

FileLock::FileLock(const fs::path& file) : m_file(file) {
    // A file that is replaced more often than it can be locked is not locked.
    constexpr int mostAttempts = 100;
    for (int attempt = 0; attempt < mostAttempts && !isLocked(); ++attempt)
        if (!tryToLock()) break;
    m_version = versionOf(file);
}

FileLock::~FileLock() {
    release();
}

bool FileLock::tryToLock() {
    // What is no regular file may wait to be opened; it is refused when it is to be written.
    std::error_code ignored;
    if (!fs::is_regular_file(m_file, ignored)) return false;
    m_descriptor = ::open(m_file.c_str(), O_RDWR | O_CLOEXEC);
    const std::optional<FileVersion> opened = versionOf(m_descriptor);
    if (!opened) return false;
    const Lock result = lock(m_descriptor);
    if (result == Lock::HeldByOther) {
        release();
        throw FileError(m_file, "is being changed by " + holderOf(*opened) +
                                    "; wait until that is done, then do this again");
    }
    const bool isThere = isSameFile(opened, versionOf(m_file));
    if (result == Lock::Impossible || !isThere) release();
    return result == Lock::Taken;
}

void FileLock::release() {
    if (m_descriptor >= 0) ::close(m_descriptor);
    m_descriptor = -1;
}

void FileLock::requireUnchanged() const {
    if (versionOf(m_file) != m_version)
        throw FileError(m_file, "was changed by another program in the meantime; do this again");
}

} // namespace esm
