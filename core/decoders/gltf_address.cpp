#include "core/decoders/gltf_address.h"

#include "core/support/errors.h"

#include <algorithm>
#include <charconv>

namespace esm {

namespace fs = std::filesystem;

namespace {

/// "liver%20left.bin" means "liver left.bin". What is no code stays as it is.
std::string withoutPercentCodes(const std::string& address) {
    std::string plain;
    for (std::size_t i = 0; i < address.size(); ++i) {
        unsigned char code = 0;
        const char* const begin = address.data() + i + 1;
        const bool isCode = address[i] == '%' && i + 2 < address.size() &&
                            std::from_chars(begin, begin + 2, code, 16).ptr == begin + 2;
        plain += isCode ? static_cast<char>(code) : address[i];
        if (isCode) i += 2;
    }
    return plain;
}

/// "file:", "https:", "C:" and the like.
bool hasScheme(const std::string& address) {
    const std::size_t end = address.find_first_of(":/");
    return end != address.npos && address[end] == ':';
}

/// Whether the name leads down from a folder by its words alone.
bool leadsDown(const std::string& name) {
    if (name.empty() || name.front() == '/' || hasScheme(name)) return false;
    // Zero ends a name before the rest is looked at; a backslash separates folders where documents are
    // written.
    if (name.find('\0') != name.npos || name.find('\\') != name.npos) return false;
    return *fs::path(name).lexically_normal().begin() != "..";
}

bool liesBelow(const fs::path& folder, const fs::path& file) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

/// In one line of a message.
std::string quoted(std::string address) {
    for (char& letter : address)
        if (static_cast<unsigned char>(letter) < ' ') letter = '?';
    constexpr std::size_t mostShown = 200;
    return '"' + (address.size() > mostShown ? address.substr(0, mostShown) + "…" : address) + '"';
}

} // namespace

/// A document from anywhere may name /etc/passwd, a pipe, or a folder above. The words of the name are
/// checked first, then where the file really lies, as a link in the folder may lead out of it; only what is
/// below the document's own folder is opened.
fs::path fileAtAddress(const fs::path& document, const std::string& address) {
    const fs::path folder = fs::absolute(document).parent_path();
    const auto refuse = [&](const std::string& reason) {
        throw FileError(document, "needs the file " + quoted(address) + ", " + reason);
    };
    const std::string outside = "which is not in the folder of this file or below; put it beside this file "
                                "and let it be named by its name alone";
    std::error_code error;
    // Some exporters name a file by what its name looks like when encoded.
    for (const std::string& name : {withoutPercentCodes(address), address}) {
        if (!leadsDown(name)) refuse(outside);
        fs::path file = fs::canonical(folder / name, error);
        if (error) continue;
        if (!liesBelow(fs::canonical(folder, error), file)) refuse(outside);
        if (fs::is_regular_file(file, error)) return file;
    }
    refuse("which is not beside it or cannot be read; copy it there, or export both again");
    return {};
}

} // namespace esm
