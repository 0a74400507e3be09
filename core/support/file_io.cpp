#include "core/support/file_io.h"

#include "core/support/atomic_file.h"
#include "core/support/errors.h"

#include <fstream>
#include <string_view>

namespace esm {

namespace fs = std::filesystem;

namespace {

void writeAtomically(const fs::path& file, std::string_view content) {
    AtomicFile output(file);
    output.write(content);
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

Bytes readFile(const fs::path& file, std::uint64_t largest) {
    const std::uint64_t size = regularFileSize(file);
    if (size > largest)
        throw FileError(file, "is larger than the " + std::to_string(largest >> 20) +
                                  " MiB that such a file may have; choose another file");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw FileError(file, "cannot be opened; check its permissions");
    Bytes content(static_cast<std::size_t>(size));
    stream.read(reinterpret_cast<char*>(content.data()), static_cast<std::streamsize>(content.size()));
    if (!stream && !content.empty()) throw FileError(file, "cannot be read to its end; check the medium");
    return content;
}

void writeFileAtomically(const fs::path& file, const Bytes& content) {
    writeAtomically(file, {reinterpret_cast<const char*>(content.data()), content.size()});
}

void writeFileAtomically(const fs::path& file, const std::string& content) {
    writeAtomically(file, std::string_view(content));
}

} // namespace esm
