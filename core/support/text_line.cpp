#include "core/support/text_line.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace esm {

namespace {

bool isControlCharacter(char character) {
    return static_cast<unsigned char>(character) < ' ' || character == '\x7F';
}

bool isUtf8(const std::string& text) {
    try {
        nlohmann::json(text).dump();
        return true;
    } catch (const nlohmann::json::type_error&) {
        return false;
    }
}

} // namespace

std::string lineProblem(const std::string& text, std::size_t mostBytes) {
    if (text.size() > mostBytes) return "must have at most " + std::to_string(mostBytes) + " bytes";
    if (!isUtf8(text)) return "must be UTF-8 text";
    if (std::any_of(text.begin(), text.end(), isControlCharacter))
        return "must be one line without control characters";
    return {};
}

std::string asLine(const std::string& text) {
    using nlohmann::json;
    const auto utf8 =
        json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace)).get<std::string>();
    std::string line;
    for (const char character : utf8)
        line += isControlCharacter(character) ? "\xEF\xBF\xBD" : std::string(1, character);
    return line;
}

} // namespace esm
