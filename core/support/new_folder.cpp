#include "core/support/new_folder.h"

#include "core/support/appended_file.h"
#include "core/support/atomic_file.h"
#include "core/support/errors.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <sys/stat.h>

namespace esm {

namespace fs = std::filesystem;

namespace {

/// Without a slash at its end, which would leave it without a name.
fs::path folderName(const fs::path& target) {
    return target.has_filename() ? target : target.parent_path();
}

void checkFree(const fs::path& target) {
    std::error_code error;
    if (target.empty()) throw FileError(target, "is no folder's name; name a folder");
    const fs::file_status status = fs::symlink_status(target, error);
    if (!fs::exists(status)) return;
    if (!fs::is_directory(status)) throw FileError(target, "is there already, and no folder; name a new one");
    if (!fs::is_empty(target, error))
        throw FileError(target, "is there already, and not empty; name a new folder");
}

/// As the process makes new folders; mkdtemp() makes them for their owner alone.
void giveUsualPermissions(const fs::path& folder) {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    ::chmod(folder.c_str(), 0777 & ~mask);
}

} // namespace

NewFolder::NewFolder(const fs::path& target) : m_target(folderName(target)) {
    checkFree(m_target);
    std::string name = m_target.string() + ".XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) throw FileError(m_target, writingProblem(errno));
    m_unfinished = name;
    giveUsualPermissions(m_unfinished);
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
        checkFree(m_target);
        throw FileError(m_target, writingProblem(reason));
    }
    m_isCommitted = true;
}

} // namespace esm
