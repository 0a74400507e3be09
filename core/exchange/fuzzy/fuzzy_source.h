#pragma once

#include "core/support/file_io.h"
#include "core/support/letters.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

/// A place in a text, both from 1; columns are counted in letters.
struct TextPlace {
    std::size_t line = 1, column = 1;
};

bool isBefore(const TextPlace& one, const TextPlace& other);

/// "line 3, column 5: problem"
std::string placed(const TextPlace& place, const std::string& problem);
[[noreturn]] void failAt(const TextPlace& place, const std::string& problem); ///< @throws InvalidModel

inline constexpr std::uint64_t largestFuzzySource = 4 << 20; ///< bytes

/// The text of a file that cannot be trusted, without byte order mark, its lines ending in a line feed.
/// @throws InvalidModel: not UTF-8, binary (with the place), or larger than any fuzzy system
std::string sourceText(const Bytes& content);

/// How a language marks what is for people; one that ends with its line has "\n" for its end.
struct RemarkForm {
    std::string_view begin, end;
};

struct TextRemark {
    TextPlace place;
    std::string text; ///< without its marks and without blanks around it
};

/// A text with its remarks taken out; there are blanks in their place, so that columns stay.
struct SourceCode {
    std::string code;
    std::vector<TextRemark> remarks; ///< in the order of the text
    TextPlace end;
};

SourceCode withoutRemarks(const std::string& text,
                          const std::vector<RemarkForm>& forms); ///< @throws InvalidModel: one without end

struct TextWord {
    std::string text;
    TextPlace place;
};

/// Words between blanks; each of the letters in `marks` is a word of its own.
/// @throws InvalidModel: a word longer than any name
std::vector<TextWord> textWords(std::string_view code, TextPlace place, std::string_view marks);

std::string_view trimmed(std::string_view text);
std::size_t letterCount(std::string_view text);

/// A text without zero bytes that remarks of every form can hold on one line, and back.
std::string asRemark(const std::string& text);
std::string fromRemark(std::string_view remark);

/// "note: made up" for the key "note".
std::optional<std::string> remarkFor(const std::string& key, const TextRemark& remark);

} // namespace esm
