#include "core/support/appended_file.h"

#include "core/support/atomic_file.h"
#include "core/support/errors.h"

#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

namespace esm {

AppendedFile::AppendedFile(const std::filesystem::path& file)
    : m_file(file), m_descriptor(::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NOFOLLOW)) {
    if (m_descriptor < 0) fail();
}

AppendedFile::~AppendedFile() {
    if (m_descriptor >= 0) ::close(m_descriptor);
}

void AppendedFile::append(std::string_view data) {
    if (!writeWhole(m_descriptor, data)) fail();
}

void AppendedFile::sync() {
    if (::fdatasync(m_descriptor) != 0) fail();
}

void AppendedFile::fail() const {
    throw FileError(m_file, writingProblem(errno));
}

void syncFolder(const std::filesystem::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const bool isSynced = descriptor >= 0 && ::fsync(descriptor) == 0;
    const int reason = errno;
    if (descriptor >= 0) ::close(descriptor);
    // Some file systems of networks cannot sync a folder; they do it by themselves.
    if (!isSynced && reason != EINVAL && reason != ENOTSUP) throw FileError(folder, writingProblem(reason));
}

} // namespace esm
