#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

/// One value of an enumeration, and how files and the command line name it.
template<class Enum> struct Word {
    Enum value;
    const char* word;
};
template<class Enum> Word(Enum, const char*) -> Word<Enum>;

/// Every value of an enumeration with its word: beside the enumeration stands a list of `Word`.
template<class Enum> inline constexpr std::nullptr_t wordsOf = nullptr;

template<class Enum>
concept HasWords = requires {
    wordsOf<Enum>.size();
};

/// Precondition: the list has the value.
template<HasWords Enum> constexpr const char* wordOf(Enum value) {
    for (const auto& [other, word] : wordsOf<Enum>)
        if (other == value) return word;
    return "";
}

template<HasWords Enum> constexpr std::optional<Enum> fromWord(std::string_view text) {
    for (const auto& [value, word] : wordsOf<Enum>)
        if (text == word) return value;
    return std::nullopt;
}

template<HasWords Enum> std::vector<std::string> allWords() {
    std::vector<std::string> words;
    words.reserve(std::size(wordsOf<Enum>));
    for (const auto& [value, word] : wordsOf<Enum>)
        words.emplace_back(word);
    return words;
}

} // namespace esm
