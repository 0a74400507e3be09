#pragma once

#include "core/support/file_io.h"

#include <fstream>
#include <string>

namespace esm {

/// Writes a file as it comes, for sweeps over thousands of damaged files that need not survive a power cut.
template<typename Content> void overwrite(const std::filesystem::path& file, const Content& content) {
    std::ofstream stream(file, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(content.data()), static_cast<std::streamsize>(content.size()));
}

} // namespace esm
