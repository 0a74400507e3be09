#pragma once

namespace esm {

/// Whether a byte of UTF-8 text begins a letter; the others go on with one.
inline bool startsLetter(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
}

} // namespace esm
