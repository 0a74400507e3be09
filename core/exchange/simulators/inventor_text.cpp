#include "core/exchange/simulators/inventor_text.h"

#include <algorithm>
#include <charconv>
#include <iterator>

namespace esm {

namespace {

constexpr std::string_view hexDigits = "0123456789abcdef";

bool isAsciiLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool isAsciiDigit(char c) {
    return c >= '0' && c <= '9';
}

} // namespace

std::string inventorName(std::string_view text) {
    std::string name(text);
    for (char& c : name)
        if (!isAsciiLetter(c) && !isAsciiDigit(c)) c = '_';
    return name.empty() || isAsciiDigit(name.front()) ? "_" + name : name;
}

std::string inventorString(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '\\';
        const bool isControl = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
        quoted += c == '\\' ? '/' : isControl ? ' ' : c;
    }
    return quoted + '"';
}

std::string inventorNumber(double value) {
    char buffer[32];
    const auto [end, error] = std::to_chars(std::begin(buffer), std::end(buffer), static_cast<float>(value));
    return {buffer, error == std::errc() ? end : buffer};
}

std::string inventorPixels(const Image& image, int row) {
    std::string text;
    text.reserve(static_cast<std::size_t>(image.width) * 9);
    for (int x = 0; x < image.width; ++x) {
        text += "0x";
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const std::uint8_t value = image.at(x, row)[channel];
            text += hexDigits[value >> 4];
            text += hexDigits[value & 15];
        }
        text += ' ';
    }
    return text;
}

} // namespace esm
