#pragma once

#include <filesystem>

namespace esm {

/// A new folder for files that nobody keeps, for this user alone, among the system's temporary ones. It goes
/// away with the object.
class ScratchFolder {
public:
    ScratchFolder(); ///< @throws FileError where there is no room for one
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder();

    const std::filesystem::path& path() const { return m_path; }

private:
    std::filesystem::path m_path;
};

} // namespace esm
