#include "core/support/file_io.h"

#include "core/support/errors.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

namespace esm {

namespace fs = std::filesystem;

namespace {

/// A new file beside the target that disappears again unless it is committed.
class TemporaryFile {
public:
    explicit TemporaryFile(const fs::path& target) : m_target(target), m_name(target.string() + ".XXXXXX") {
        m_descriptor = ::mkstemp(m_name.data());
        if (m_descriptor < 0) fail();
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (m_descriptor >= 0) ::close(m_descriptor);
        if (!m_committed) ::unlink(m_name.c_str());
    }

    void write(const char* data, std::size_t size) {
        while (size > 0) {
            const ssize_t written = ::write(m_descriptor, data, size);
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) fail();
            data += written;
            size -= static_cast<std::size_t>(written);
        }
    }

    void commit(mode_t mode) {
        if (::fchmod(m_descriptor, mode) != 0 || ::fsync(m_descriptor) != 0) fail();
        const int descriptor = m_descriptor;
        m_descriptor = -1;
        if (::close(descriptor) != 0 || ::rename(m_name.c_str(), m_target.c_str()) != 0) fail();
        m_committed = true;
    }

private:
    [[noreturn]] void fail() const {
        throw FileError(m_target, std::string("cannot be written: ") + std::strerror(errno) +
                                      "; choose another folder or free some space");
    }

    fs::path m_target;
    std::string m_name;
    int m_descriptor = -1;
    bool m_committed = false;
};

/// The permissions an existing file has, or those a new file gets.
mode_t permissionsOf(const fs::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) == 0) return status.st_mode & 07777;
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
}

void writeAtomically(const fs::path& file, const char* data, std::size_t size) {
    std::error_code ignored;
    const fs::path target = fs::is_symlink(file, ignored) ? fs::canonical(file, ignored) : file;
    const fs::path destination = target.empty() ? file : target;
    if (fs::is_directory(destination, ignored)) throw FileError(file, "is a folder; name a file");
    TemporaryFile temporary(destination);
    temporary.write(data, size);
    temporary.commit(permissionsOf(destination));
}

} // namespace

Bytes readFile(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (!fs::exists(status)) throw FileError(file, "does not exist; check the name");
    if (!fs::is_regular_file(status)) throw FileError(file, "is not a regular file; name a file");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw FileError(file, "cannot be opened; check its permissions");
    Bytes content(static_cast<std::size_t>(fs::file_size(file, error)));
    stream.read(reinterpret_cast<char*>(content.data()), static_cast<std::streamsize>(content.size()));
    if (!stream && !content.empty()) throw FileError(file, "cannot be read to its end; check the medium");
    return content;
}

void writeFileAtomically(const fs::path& file, const Bytes& content) {
    writeAtomically(file, reinterpret_cast<const char*>(content.data()), content.size());
}

void writeFileAtomically(const fs::path& file, const std::string& content) {
    writeAtomically(file, content.data(), content.size());
}

} // namespace esm
