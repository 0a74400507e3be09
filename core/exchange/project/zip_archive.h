#pragma once

#include "core/support/file_io.h"
#include "core/support/progress.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace esm {

struct ZipEntry {
    std::string name;
    Bytes content;
    bool compressed = true; ///< false for what is compressed already
};

/// A zip archive in memory. The same entries give the same bytes: no dates, no names of users.
/// @throws Cancelled
Bytes makeZip(const std::vector<ZipEntry>& entries, const Progress& progress = {});

/// Reads a zip archive that cannot be trusted. Sizes are what really comes out, not what the archive claims.
class ZipReader {
public:
    /// `archive` must outlive the reader. @throws InvalidModel when it is no zip archive or its directory is
    /// damaged
    explicit ZipReader(const Bytes& archive);
    ZipReader(const ZipReader&) = delete;
    ZipReader& operator=(const ZipReader&) = delete;
    ~ZipReader();

    /// @throws InvalidModel naming the entry: missing, damaged or larger than `largest` bytes
    /// Cancelled
    Bytes read(const std::string& entry, std::uint64_t largest, const Progress& progress = {}) const;

private:
    struct Handle;
    std::unique_ptr<Handle> m_handle;
};

} // namespace esm
