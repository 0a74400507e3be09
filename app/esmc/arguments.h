#pragma once

#include "core/dynamics/settings.h"
#include "core/fuzzy/inference.h"
#include "core/geometry/ellipsoid.h"
#include "core/support/joined.h"
#include "core/support/words.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace esm {

/// Numbers of at most `largestNumber` separated by spaces or commas. @throws UsageError naming `option` and
/// what is no number
std::vector<double> parseNumbers(const std::string& text, const std::string& option);

/// NAME=V with such a number. @throws UsageError
NamedValues parsePairs(const std::vector<std::string>& pairs, const std::string& option);

/// Values as they were typed, by name, in the order of the command line.
using NamedWords = std::vector<std::pair<std::string, std::string>>;

/// NAME=V with any V. @throws UsageError
NamedWords parseNamedWords(const std::vector<std::string>& pairs, const std::string& option);

/// Inputs of a fuzzy system: such numbers, or terms, which stand for the middle of their cores.
/// @throws UsageError listing the terms or the inputs there are
NamedValues inputsFor(const FuzzySystem& system, const NamedWords& words, const std::string& option);

/// "cx cy cz rx ry rz [ax ay az degrees]". @throws UsageError
Ellipsoid parseEllipsoid(const std::string& text);

/// Words separated by commas, each one of `known`. @throws UsageError listing those there are
std::vector<std::string> parseWords(const std::string& text, const std::vector<std::string>& known,
                                    const std::string& option);

/// A check for an option that takes a number above zero, at most `largestNumber`.
CLI::Validator positiveNumber();

/// The same from a least one to a largest.
CLI::Validator numberWithin(double least, double most);

/// Of errors (relative to the motion) and speeds (times real time) that are asked for: what is beyond no run
/// comes near, and has no place on a chart.
inline constexpr double leastWish = 1e-12, mostWish = 1e12;

/// The same from zero to `largestNumber`.
CLI::Validator nonNegativeNumber();

/// Digits and perhaps a minus, always decimal: "0100" is a hundred. Nothing where that is not a number from
/// `least` to `most`.
std::optional<int> parseWholeNumber(const std::string& text, int least, int most);

/// For `transform` of an option that takes a whole number: the number as `parseWholeNumber` understands it.
CLI::Validator wholeNumber(int least, int most);
/// The same of any number, for options whose range the work knows better.
CLI::Validator wholeNumber();

/// A check for a file to write. Refused are `-`, which elsewhere means standard output, and the ending of
/// another kind of file that the program writes or reads; no ending, or one that is part of the name, is not.
/// @param ending ".png"
CLI::Validator writtenAs(const std::string& ending);
/// What that check says; empty when the file may be written.
std::string endingProblem(const std::string& file, const std::string& ending);
/// The same for a chart, which may be of two kinds.
CLI::Validator writtenAsChart();
/// A check for a folder to write to, which `-` does not name.
CLI::Validator namedFolder();

/// A check for an option whose values are known; the message of any other value lists them.
CLI::Validator oneOf(const std::vector<std::string>& values);

/// The words of an option, each with what it means.
template<typename Value> using Words = std::vector<std::pair<std::string, Value>>;

/// Adds an option that takes one of `words` and nothing else; `chosen` keeps its value without the option.
template<typename Value>
CLI::Option* addChoice(CLI::App& command, const std::string& name, Value& chosen, const Words<Value>& words,
                       const std::string& description) {
    std::vector<std::string> known;
    for (const auto& [word, value] : words)
        known.push_back(word);
    const auto choose = [&chosen, words](const std::string& given) {
        for (const auto& [word, value] : words)
            if (word == given) chosen = value;
    };
    return command.add_option_function<std::string>(name, choose, description)
        ->check(oneOf(known))
        ->option_text(joined(known, "|"));
}

/// Adds an option that takes the words of an enumeration.
template<HasWords Value>
CLI::Option* addChoice(CLI::App& command, const std::string& name, Value& chosen,
                       const std::string& description) {
    Words<Value> words;
    words.reserve(wordsOf<Value>.size());
    for (const auto& [value, word] : wordsOf<Value>)
        words.emplace_back(word, value);
    return addChoice(command, name, chosen, words, description);
}

/// --springs: whether a surface's springs make an even sheet.
CLI::Option* addSpringsChoice(CLI::App& command, bool& isEven);

/// --damping: what the springs' viscosity damps.
void addDampingOption(CLI::App& command, Damping& damping);

} // namespace esm
