#include "core/c/failure.h"

#include "core/support/errors.h"

#include <algorithm>
#include <cstring>

namespace esm {

namespace {

/// A byte of a character of UTF-8 that is not its first.
bool goesOn(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
}

} // namespace

void report(EsmError* error, const std::string& text) {
    if (!error) return;
    constexpr const char* ellipsis = "…";
    constexpr std::size_t room = sizeof error->text - 1;
    std::string shown = text;
    if (text.size() > room) {
        std::size_t size = room - std::strlen(ellipsis);
        while (size > 0 && goesOn(text[size]))
            --size;
        shown = text.substr(0, size) + ellipsis;
    }
    std::copy_n(shown.c_str(), shown.size() + 1, error->text);
}

void report(EsmError* error, const std::exception& reason) {
    report(error, reasonOf(reason));
}

} // namespace esm
