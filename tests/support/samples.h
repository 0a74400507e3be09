#pragma once

#include <algorithm>
#include <filesystem>
#include <vector>

namespace esm {

/// Files of earlier programs that have to load for ever, in order of their names; see the README in
/// `tests/data`.
inline std::vector<std::filesystem::path> samples(const char* kind) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(ESM_SOURCE_DIR) / "tests/data" / kind))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace esm
