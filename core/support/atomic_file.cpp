#include "core/support/atomic_file.h"

#include "core/support/errors.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace esm {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t bufferSize = 1 << 20;

/// The permissions an existing file has, or those a new file gets.
mode_t permissionsOf(const fs::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) == 0) return status.st_mode & 07777;
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
}

/// Where a path leads, or why it cannot be written.
fs::path checkedTarget(const fs::path& file) {
    std::error_code error;
    if (file.empty() || !file.has_filename()) throw FileError(file, "is no file's name; name a file");
    const fs::file_status status = fs::status(file, error);
    if (fs::is_directory(status)) throw FileError(file, "is a folder; name a file");
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw FileError(file, "is not a regular file; name another file to write to");
    const fs::path target = fs::is_symlink(file, error) ? fs::weakly_canonical(file, error) : file;
    const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
    if (!fs::is_directory(folder, error))
        throw FileError(file, "cannot be written: the folder " + folder.string() +
                                  " does not exist; make it first");
    return target;
}

std::string descriptorPath(int descriptor) {
    return "/proc/self/fd/" + std::to_string(descriptor);
}

/// A file without a name, or -1 where the file system has no such thing.
int openNameless(const fs::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
    if (descriptor < 0) return -1;
    if (::access(descriptorPath(descriptor).c_str(), F_OK) == 0) return descriptor;
    ::close(descriptor);
    return -1;
}

} // namespace

AtomicFile::AtomicFile(const fs::path& target) : m_file(target), m_target(checkedTarget(target)) {
    m_descriptor = openNameless(m_target.has_parent_path() ? m_target.parent_path() : ".");
    if (m_descriptor >= 0) return;
    std::string name = m_target.string() + ".XXXXXX";
    m_descriptor = ::mkstemp(name.data());
    if (m_descriptor < 0) fail();
    m_name = name;
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
    while (!data.empty()) {
        const ssize_t written = ::write(m_descriptor, data.data(), data.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail();
        data.remove_prefix(static_cast<std::size_t>(written));
    }
}

void AtomicFile::giveName() {
    const std::string from = descriptorPath(m_descriptor);
    for (int attempt = 0; m_name.empty(); ++attempt) {
        const std::string name =
            m_target.string() + "." + std::to_string(::getpid()) + "-" + std::to_string(attempt);
        if (::linkat(AT_FDCWD, from.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0)
            m_name = name;
        else if (errno != EEXIST)
            fail();
    }
}

void AtomicFile::sync() {
    flush();
    if (::fsync(m_descriptor) != 0) fail();
}

void AtomicFile::commit() {
    if (::fchmod(m_descriptor, permissionsOf(m_target)) != 0) fail();
    sync();
    if (m_name.empty()) giveName();
    const int descriptor = m_descriptor;
    m_descriptor = -1;
    if (::close(descriptor) != 0 || ::rename(m_name.c_str(), m_target.c_str()) != 0) fail();
    m_name.clear();
}

void AtomicFile::fail() const {
    const int reason = errno;
    const bool isFull = reason == ENOSPC || reason == EDQUOT || reason == EFBIG;
    throw FileError(m_file, std::string("cannot be written: ") + std::strerror(reason) +
                                (isFull ? "; free some space or choose another place"
                                        : "; choose a folder that can be written to"));
}

} // namespace esm
