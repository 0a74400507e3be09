#include "core/support/new_folder.h"

#include "core/support/appended_file.h"
#include "core/support/atomic_file.h"
#include "core/support/errors.h"

#include <cerrno>
#include <cstdio>
#include <sys/stat.h>
#include <unistd.h>

namespace esm {

namespace fs = std::filesystem;

namespace {

/// Without a slash at its end, which would leave it without a name.
fs::path folderName(const fs::path& target) {
    return target.has_filename() ? target : target.parent_path();
}

/// Of a name that nothing has yet, as the process makes new folders. mkdtemp() would make it for the user
/// alone, and what others may do can be asked for only by changing it for all threads.
fs::path newFolderBeside(const fs::path& target) {
    for (int attempt = 0;; ++attempt) {
        const std::string name =
            target.string() + '.' + std::to_string(::getpid()) + '-' + std::to_string(attempt);
        if (::mkdir(name.c_str(), 0777) == 0) return name;
        if (errno != EEXIST) throw FileError(target, writingProblem(errno));
    }
}

} // namespace

void requireNewFolder(const fs::path& name) {
    const fs::path target = folderName(name);
    std::error_code error;
    if (target.empty()) throw FileError(target, "is no folder's name; name a folder");
    const fs::file_status status = fs::symlink_status(target, error);
    if (!fs::exists(status)) return;
    if (!fs::is_directory(status)) throw FileError(target, "is there already, and no folder; name a new one");
    if (!fs::is_empty(target, error))
        throw FileError(target, "is there already, and not empty; name a new folder");
}

NewFolder::NewFolder(const fs::path& target) : m_target(folderName(target)) {
    requireNewFolder(m_target);
    m_unfinished = newFolderBeside(m_target);
}

NewFolder::~NewFolder() {
    std::error_code error;
    if (!m_isCommitted) fs::remove_all(m_unfinished, error);
}

/// rename() takes the place of an empty folder, and of no other.
void NewFolder::commit() {
    syncFolder(m_unfinished);
    if (::rename(m_unfinished.c_str(), m_target.c_str()) != 0) {
        const int reason = errno;
        requireNewFolder(m_target);
        throw FileError(m_target, writingProblem(reason));
    }
    m_isCommitted = true;
}

} // namespace esm
