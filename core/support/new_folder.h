#pragma once

#include <filesystem>

namespace esm {

/// @throws FileError when there is a file of that name, or a folder that is not empty
void requireNewFolder(const std::filesystem::path& name);

/// A folder of files that comes to be whole or not at all. It grows beside its target under another name,
/// which commit() changes; without that it goes away with the object. A folder that holds something is never
/// touched.
class NewFolder {
public:
    /// @throws FileError when the target is a file, or a folder that is not empty, or when no folder can be
    /// made beside it
    explicit NewFolder(const std::filesystem::path& target);
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;
    ~NewFolder();

    const std::filesystem::path& unfinished() const { return m_unfinished; } ///< where files go meanwhile
    void commit(); ///< @throws FileError, also when something has come to stand at the target

private:
    std::filesystem::path m_target, m_unfinished;
    bool m_isCommitted = false;
};

} // namespace esm
