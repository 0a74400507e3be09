#include "core/support/file_io.h"

#include "core/support/atomic_file.h"
#include "core/support/errors.h"

#include <algorithm>
#include <fstream>
#include <string_view>

namespace esm {

namespace fs = std::filesystem;

namespace {

/// So much reaches the disk, or comes from it, within a moment.
constexpr std::size_t piece = 8 << 20;

void writeAtomically(const fs::path& file, std::string_view content, const Progress& progress) {
    AtomicFile output(file);
    for (std::size_t done = 0; done < content.size(); done += piece) {
        reportProgress(progress, static_cast<double>(done) / static_cast<double>(content.size()));
        output.write(content.substr(done, piece));
        if (progress) output.sync(); // or all of it would have to wait for the disk at the end
    }
    reportProgress(progress, 1);
    output.commit();
}

} // namespace

std::uint64_t regularFileSize(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found) throw FileError(file, "does not exist; check the name");
    if (!fs::status_known(status))
        throw FileError(file, "cannot be reached: " + error.message() + "; check the folder's permissions");
    if (!fs::is_regular_file(status)) throw FileError(file, "is not a regular file; name a file");
    const std::uintmax_t size = fs::file_size(file, error);
    if (error) throw FileError(file, "cannot be read: " + error.message() + "; check the medium");
    return size;
}

Bytes readFile(const fs::path& file, std::uint64_t largest, const Progress& progress) {
    const std::uint64_t size = regularFileSize(file);
    if (size > largest)
        throw FileError(file, "is larger than the " + std::to_string(largest >> 20) +
                                  " MiB that such a file may have; choose another file");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw FileError(file, "cannot be opened; check its permissions");
    Bytes content(static_cast<std::size_t>(size));
    for (std::size_t done = 0; done < content.size(); done += piece) {
        reportProgress(progress, static_cast<double>(done) / static_cast<double>(content.size()));
        stream.read(reinterpret_cast<char*>(&content[done]),
                    static_cast<std::streamsize>(std::min(piece, content.size() - done)));
    }
    if (!stream && !content.empty()) throw FileError(file, "cannot be read to its end; check the medium");
    return content;
}

void writeFileAtomically(const fs::path& file, const Bytes& content, const Progress& progress) {
    writeAtomically(file, {reinterpret_cast<const char*>(content.data()), content.size()}, progress);
}

void writeFileAtomically(const fs::path& file, const std::string& content) {
    writeAtomically(file, std::string_view(content), {});
}

} // namespace esm
