#include "core/support/scratch_folder.h"

#include "core/support/atomic_file.h"
#include "core/support/errors.h"

#include <cerrno>
#include <cstdlib>

namespace esm {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
    std::error_code error;
    const fs::path among = fs::temp_directory_path(error);
    if (error)
        throw FileError("the folder for temporary files",
                        "is none; name one that can be written to in the environment's TMPDIR");
    std::string name = (among / "esm-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw FileError(among, writingProblem(errno));
    m_path = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
}

} // namespace esm
