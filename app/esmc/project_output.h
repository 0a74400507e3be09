#pragma once

#include "core/project/project.h"
#include "core/support/file_lock.h"

namespace esm {

/// The project that a command writes. To be made before anything is read: from then on until the command has
/// ended no other one may write the file, so that none of two changes to one project is lost.
class ProjectOutput {
public:
    /// @throws FileError where another one writes it
    explicit ProjectOutput(const std::filesystem::path& file);

    const std::filesystem::path& file() const { return m_file; }
    /// @throws FileError, InvalidModel as saveProject(), or where another program changed the file
    void save(const Project& project) const;

private:
    std::filesystem::path m_file;
    FileLock m_lock;
};

} // namespace esm
