#pragma once

#include "core/support/errors.h"
#include "core/support/file_io.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace esm {

/// Lines and words of a text in memory, for checks of text formats.
class TextLines {
public:
    explicit TextLines(const Bytes& content)
        : m_text(reinterpret_cast<const char*>(content.data()), content.size()) {}

    /// The next line without its end; false at the end of the text.
    bool next(std::string_view& line) {
        if (m_at >= m_text.size()) return false;
        const std::size_t end = std::min(m_text.find('\n', m_at), m_text.size());
        line = m_text.substr(m_at, end - m_at);
        while (!line.empty() && (line.back() == '\r' || line.back() == '\0'))
            line.remove_suffix(1);
        m_at = end + 1;
        ++m_number;
        return true;
    }

    std::size_t number() const { return m_number; } ///< of the line last returned, from 1

private:
    std::string_view m_text;
    std::size_t m_at = 0, m_number = 0;
};

/// Takes the next word off the front of a line; empty at its end.
inline std::string_view takeWord(std::string_view& line) {
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin == line.npos) return line = {};
    const std::size_t end = std::min(line.find_first_of(" \t", begin), line.size());
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
}

/// The number that a word is, if it is one: "12", "+1.5e-3", "nan". A number too large for `double` is
/// infinite.
template<typename Number> std::optional<Number> wholeNumber(std::string_view word) {
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    Number value{};
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    if (result.ptr != word.data() + word.size() || result.ec == std::errc::invalid_argument)
        return std::nullopt;
    if (result.ec == std::errc()) return value;
    if constexpr (!std::numeric_limits<Number>::has_infinity) return std::nullopt;
    const bool tiny = word.find("e-") != word.npos || word.find("E-") != word.npos;
    return tiny ? Number{} : std::numeric_limits<Number>::infinity();
}

/// Bytes of value 0 are in no text; some exporters leave them at its end.
/// @throws FileError naming the first one that something follows
inline void refuseBinary(const std::filesystem::path& file, const Bytes& content, const std::string& format) {
    const auto end =
        std::find_if(content.rbegin(), content.rend(), [](std::uint8_t byte) { return byte != 0; }).base();
    const auto found = std::find(content.begin(), end, 0);
    if (found == end) return;
    throw FileError(file, "is not " + format + " text: it has binary data at byte " +
                              std::to_string(found - content.begin()) +
                              "; choose a file of the kind its ending says, or export it again");
}

} // namespace esm
