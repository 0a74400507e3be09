#pragma once

#include <filesystem>
#include <string>

namespace esm {

/// The file that a glTF document names by an address, percent-encoded or not. A document may come from
/// anybody, and what it names is opened with its user's rights: only files in the document's folder or below
/// it are meant, wherever the names on the way, symbolic links too, lead in the end.
/// @return its path without symbolic links
/// @throws FileError naming the document and the address, when the file lies elsewhere or is not there
std::filesystem::path fileAtAddress(const std::filesystem::path& document, const std::string& address);

} // namespace esm
