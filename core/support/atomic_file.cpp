#include "core/support/atomic_file.h"

#include "core/support/errors.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <sys/stat.h>
#include <unistd.h>

namespace esm {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t bufferSize = 1 << 20;

/// The permissions of an existing file.
std::optional<mode_t> permissionsOf(const fs::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return std::nullopt;
    return status.st_mode & 07777;
}

/// Renaming would replace what its owner has protected, and the superuser may write everywhere. Of a file
/// system that nothing may be written to the file is not to blame.
bool isWriteProtected(const fs::path& file) {
    const std::optional<mode_t> permissions = permissionsOf(file);
    if (!permissions) return false;
    const bool isRefused = ::faccessat(AT_FDCWD, file.c_str(), W_OK, AT_EACCESS) != 0 && errno != EROFS;
    return (*permissions & 0222) == 0 || isRefused;
}

/// Where a path leads, or why it cannot be written.
fs::path checkedTarget(const fs::path& file) {
    std::error_code error;
    if (file.empty() || !file.has_filename()) throw FileError(file, "is no file's name; name a file");
    const fs::file_status status = fs::status(file, error);
    if (!fs::status_known(status))
        throw FileError(file, "cannot be reached: " + error.message() + "; check the folder's permissions");
    if (fs::is_directory(status)) throw FileError(file, "is a folder; name a file");
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw FileError(file, "is not a regular file; name another file to write to");
    if (!fs::exists(status) && fs::is_symlink(file, error))
        throw FileError(file, "is a link to " + fs::read_symlink(file, error).string() +
                                  ", which does not exist; remove the link or name another file");
    if (isWriteProtected(file))
        throw FileError(file, "is write-protected; allow writing to it or name another file");
    return fs::is_symlink(file, error) ? fs::canonical(file, error) : file;
}

fs::path folderOf(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : ".";
}

std::string descriptorPath(int descriptor) {
    return "/proc/self/fd/" + std::to_string(descriptor);
}

/// A file without a name, or -1 where the file system has no such thing.
int openNameless(const fs::path& folder, mode_t permissions) {
    const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, permissions);
    if (descriptor < 0) return -1;
    if (::access(descriptorPath(descriptor).c_str(), F_OK) == 0) return descriptor;
    ::close(descriptor);
    return -1;
}

/// Offers names that begin like the file's until `take` says that one was free. False, with errno, on another
/// error.
template<typename Take> bool takeFreeName(const fs::path& file, std::string& taken, Take take) {
    for (int attempt = 0;; ++attempt) {
        const std::string name =
            file.string() + "." + std::to_string(::getpid()) + "-" + std::to_string(attempt);
        if (take(name.c_str())) {
            taken = name;
            return true;
        }
        if (errno != EEXIST) return false;
    }
}

} // namespace

std::string writingProblem(int reason) {
    const bool isFull = reason == ENOSPC || reason == EDQUOT || reason == EFBIG;
    const char* remedy = "; choose a folder that can be written to";
    if (isFull) remedy = "; free some space or choose another place";
    if (reason == ENAMETOOLONG) remedy = "; choose a shorter name";
    if (reason == ENOENT) remedy = "; make its folder first";
    return std::string("cannot be written: ") + std::strerror(reason) + remedy;
}

bool writeWhole(int descriptor, std::string_view data) {
    while (!data.empty()) {
        const ssize_t written = ::write(descriptor, data.data(), data.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        data.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

AtomicFile::AtomicFile(const fs::path& target) : AtomicFile(target, {}) {}

AtomicFile::AtomicFile(const fs::path& target, const fs::path& unfinishedIn)
    : m_file(target), m_target(checkedTarget(target)) {
    const fs::path folder = unfinishedIn.empty() ? folderOf(m_target) : unfinishedIn;
    std::error_code error;
    if (!fs::is_directory(folder, error))
        throw FileError(target, "cannot be written: the folder " + folder.string() +
                                    " does not exist; make it first");
    // Never readable by more than the file it replaces; a new one gets what the process gives new files.
    const mode_t permissions = permissionsOf(m_target).value_or(0666) & 0666;
    m_descriptor = openNameless(folder, permissions);
    if (m_descriptor >= 0) return;
    const auto create = [&](const char* name) {
        m_descriptor = ::open(name, O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, permissions);
        return m_descriptor >= 0;
    };
    if (!takeFreeName(folder / m_target.filename(), m_name, create)) fail();
}

AtomicFile::~AtomicFile() {
    if (m_descriptor >= 0) ::close(m_descriptor);
    if (!m_name.empty()) ::unlink(m_name.c_str());
}

void AtomicFile::write(std::string_view data) {
    if (m_buffer.size() + data.size() > bufferSize) flush();
    if (data.size() > bufferSize)
        writeOut(data);
    else
        m_buffer.append(data);
}

void AtomicFile::flush() {
    writeOut(m_buffer);
    m_buffer.clear();
}

void AtomicFile::writeOut(std::string_view data) {
    if (!writeWhole(m_descriptor, data)) fail();
}

void AtomicFile::giveName() {
    const std::string from = descriptorPath(m_descriptor);
    const auto link = [&](const char* name) {
        return ::linkat(AT_FDCWD, from.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW) == 0;
    };
    if (!takeFreeName(m_target, m_name, link)) fail();
}

void AtomicFile::sync() {
    flush();
    if (::fsync(m_descriptor) != 0) fail();
}

void AtomicFile::commit() {
    const std::optional<mode_t> permissions = permissionsOf(m_target);
    if (permissions && ::fchmod(m_descriptor, *permissions) != 0) fail();
    sync();
    if (m_name.empty()) giveName();
    const int descriptor = m_descriptor;
    m_descriptor = -1;
    if (::close(descriptor) != 0 || ::rename(m_name.c_str(), m_target.c_str()) != 0) fail();
    m_name.clear();
}

void AtomicFile::fail() const {
    throw FileError(m_file, writingProblem(errno));
}

} // namespace esm
