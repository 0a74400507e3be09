#include "core/exchange/fuzzy/fuzzy_source.h"

#include "core/support/errors.h"

#include <algorithm>
#include <charconv>

namespace esm {

namespace {

constexpr std::string_view blankLetters = " \t\n\f\v";

void advancePlace(TextPlace& place, char c) {
    if (c == '\n')
        place = {place.line + 1, 1};
    else if (startsLetter(c))
        ++place.column;
}

/// Bytes of the UTF-8 letter that the text begins with; 0 where it is none.
std::size_t letterLength(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : static_cast<unsigned char>(0);
    };
    const unsigned first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t length = first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
    for (std::size_t i = 1; i < length; ++i)
        if (i >= text.size() || startsLetter(text[i])) return 0;
    const bool isOverlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
    const bool isNoLetter = (first == 0xED && byte(1) > 0x9F) || (first == 0xF4 && byte(1) > 0x8F);
    return isOverlong || isNoLetter ? 0 : length;
}

bool looksLikeUtf16(std::string_view text) {
    if (text.size() < 2) return false;
    const auto first = static_cast<unsigned char>(text[0]), second = static_cast<unsigned char>(text[1]);
    return (first == 0xFF && second == 0xFE) || (first == 0xFE && second == 0xFF) ||
           (first == 0) != (second == 0);
}

void checkLetters(std::string_view text) {
    TextPlace place;
    while (!text.empty()) {
        const auto first = static_cast<unsigned char>(text.front());
        if (first < ' ' && blankLetters.find(text.front()) == blankLetters.npos)
            failAt(place, "is not text: there is binary data");
        const std::size_t length = letterLength(text);
        if (length == 0) failAt(place, "is not UTF-8 text; save it as UTF-8");
        advancePlace(place, text.front());
        text.remove_prefix(length);
    }
}

std::string withLineFeeds(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
        result += text[i] == '\r' ? '\n' : text[i];
    }
    return result;
}

std::optional<char> fromHexadecimal(std::string_view digits) {
    unsigned value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    const bool isRead = digits.size() == 2 && error == std::errc() && end == digits.data() + digits.size();
    if (!isRead || value == 0 || value > ' ') return std::nullopt;
    return static_cast<char>(value);
}

} // namespace

bool isBefore(const TextPlace& one, const TextPlace& other) {
    return one.line != other.line ? one.line < other.line : one.column < other.column;
}

std::string placed(const TextPlace& place, const std::string& problem) {
    return "line " + std::to_string(place.line) + ", column " + std::to_string(place.column) + ": " + problem;
}

void failAt(const TextPlace& place, const std::string& problem) {
    throw InvalidModel(placed(place, problem));
}

std::string sourceText(const Bytes& content) {
    if (content.size() > largestFuzzySource)
        throw InvalidModel("is too large; a fuzzy system may have " +
                           std::to_string(largestFuzzySource >> 20) + " MB");
    std::string_view bytes(reinterpret_cast<const char*>(content.data()), content.size());
    if (looksLikeUtf16(bytes)) failAt({}, "is UTF-16 text; save it as UTF-8");
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    if (bytes.substr(0, byteOrderMark.size()) == byteOrderMark) bytes.remove_prefix(byteOrderMark.size());
    std::string text = withLineFeeds(bytes);
    checkLetters(text);
    return text;
}

SourceCode withoutRemarks(const std::string& text, const std::vector<RemarkForm>& forms) {
    SourceCode source;
    source.code.reserve(text.size());
    TextPlace& place = source.end;
    for (std::size_t at = 0; at < text.size();) {
        const auto form = std::find_if(forms.begin(), forms.end(), [&](const RemarkForm& f) {
            return text.compare(at, f.begin.size(), f.begin) == 0;
        });
        if (form == forms.end()) {
            source.code += text[at];
            advancePlace(place, text[at++]);
            continue;
        }
        const std::size_t begin = at + form->begin.size();
        const bool endsWithLine = form->end == "\n";
        std::size_t end = text.find(form->end, begin);
        if (end == text.npos && !endsWithLine)
            failAt(place, "the remark does not end; expected \"" + std::string(form->end) + "\"");
        end = std::min(end, text.size());
        source.remarks.push_back(
            {place, std::string(trimmed(std::string_view(text).substr(begin, end - begin)))});
        const std::size_t next = endsWithLine ? end : end + form->end.size();
        for (; at < next; advancePlace(place, text[at++])) {
            if (startsLetter(text[at])) source.code += text[at] == '\n' ? '\n' : ' ';
        }
    }
    return source;
}

std::vector<TextWord> textWords(std::string_view code, TextPlace place, std::string_view marks) {
    constexpr std::size_t longestWord = 200;
    std::vector<TextWord> words;
    bool inWord = false;
    for (const char c : code) {
        const bool isBlank = blankLetters.find(c) != blankLetters.npos;
        const bool isMark = marks.find(c) != marks.npos;
        if (!isBlank) {
            if (!inWord || isMark) words.push_back({"", place});
            words.back().text += c;
            if (words.back().text.size() > longestWord)
                failAt(words.back().place, "there is a word of more than " + std::to_string(longestWord) +
                                               " bytes; no name and no number is that long");
        }
        inWord = !isBlank && !isMark;
        advancePlace(place, c);
    }
    return words;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(blankLetters);
    if (begin == text.npos) return {};
    return text.substr(begin, text.find_last_not_of(blankLetters) - begin + 1);
}

std::size_t letterCount(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), startsLetter));
}

std::string asRemark(const std::string& text) {
    constexpr const char* digits = "0123456789abcdef";
    std::string remark;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const auto byte = static_cast<unsigned char>(c);
        const bool isAtEnd = i == 0 || i + 1 == text.size(); // where blanks would be lost
        if (c == '\\')
            remark += "\\\\";
        else if (c == '\n')
            remark += "\\n";
        else if (c == ')' && i > 0 && text[i - 1] == '*')
            remark += "\\)";
        else if (byte == 0) // is no letter, and is not read
            continue;
        else if (byte < ' ' || (c == ' ' && isAtEnd))
            remark.append("\\x").append(1, digits[byte / 16]).append(1, digits[byte % 16]);
        else
            remark += c;
    }
    return remark;
}

std::string fromRemark(std::string_view remark) {
    std::string text;
    for (std::size_t i = 0; i < remark.size(); ++i) {
        const char next = remark[i] == '\\' && i + 1 < remark.size() ? remark[i + 1] : '\0';
        const std::optional<char> coded =
            next == 'x' ? fromHexadecimal(remark.substr(i + 2, 2)) : std::nullopt;
        if (coded) {
            text += *coded;
            i += 3;
        } else if (next == '\\' || next == ')' || next == 'n') {
            text += next == 'n' ? '\n' : next;
            ++i;
        } else {
            text += remark[i];
        }
    }
    return text;
}

std::optional<std::string> remarkFor(const std::string& key, const TextRemark& remark) {
    if (remark.text.compare(0, key.size(), key) != 0 || remark.text.size() == key.size() ||
        remark.text[key.size()] != ':')
        return std::nullopt;
    return fromRemark(trimmed(std::string_view(remark.text).substr(key.size() + 1)));
}

} // namespace esm
