#pragma once

#include <filesystem>
#include <string>

namespace esm {

/// Whether a byte of UTF-8 text begins a letter; the others go on with one.
inline bool startsLetter(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
}

/// Only A to Z become small: what is compared are words of file formats, whatever the user's language.
inline std::string inSmallLetters(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

/// The name's ending in small letters, with its dot; empty where it has none.
inline std::string endingOf(const std::filesystem::path& file) {
    return inSmallLetters(file.extension().string());
}

} // namespace esm
