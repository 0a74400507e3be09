#pragma once

#include "core/support/progress.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace esm {

using Bytes = std::vector<std::uint8_t>;

/// Bytes of a file. @throws FileError when it is missing or not a regular file.
std::uint64_t regularFileSize(const std::filesystem::path& file);

/// Bytes of any file that this program reads whole.
inline constexpr std::uint64_t largestFile = std::uint64_t{4} << 30;

/// Reads a whole file. @throws FileError when it is missing, not a regular file, unreadable or larger than
/// `largest` bytes, before memory for it is taken; Cancelled
Bytes readFile(const std::filesystem::path& file, std::uint64_t largest = largestFile,
               const Progress& progress = {});

/// Replaces `file` by `content`, or leaves it untouched: written to a new file beside it, synced, renamed.
/// @throws FileError when the folder is missing or read-only, the file is write-protected or the disk is
/// full, Cancelled by any of the reports; the new file is removed.
void writeFileAtomically(const std::filesystem::path& file, const Bytes& content,
                         const Progress& progress = {});
void writeFileAtomically(const std::filesystem::path& file, const std::string& content);

} // namespace esm
