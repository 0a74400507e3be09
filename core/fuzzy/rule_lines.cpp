#include "core/fuzzy/rule_lines.h"

#include "core/support/joined.h"

#include <algorithm>

namespace esm {

bool isBlank(const std::string& line) {
    return std::all_of(line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) <= ' '; });
}

std::string rulesText(const FuzzySystem& system) {
    std::vector<std::string> lines;
    lines.reserve(system.rules.size());
    for (const FuzzyRule& rule : system.rules)
        lines.push_back(ruleText(system, rule));
    return joined(lines, "\n");
}

/// Line by line, so that a mistake costs one rule and not those behind it: while a rule is being typed,
/// nearly every text has one.
RulesReading readRules(const FuzzySystem& system, const std::vector<std::string>& lines) {
    RulesReading reading;
    const auto count = static_cast<std::size_t>(
        std::count_if(lines.begin(), lines.end(), [](const std::string& line) { return !isBlank(line); }));
    if (count > mostFuzzyRules) {
        reading.problem = tooManyRules(count);
        return reading;
    }
    std::size_t number = 0;
    for (std::size_t line = 0; line < lines.size(); ++line) {
        if (isBlank(lines[line])) continue;
        ++number;
        try {
            reading.rules.push_back(parseRule(system, lines[line]));
        } catch (const RuleError& error) {
            reading.unread.push_back({line, number, error.what(), error.mistake()});
        }
    }
    return reading;
}

/// The parser itself tells what could come next: where the text ends too early, its mistake lists what it
/// expected there. So completion and grammar cannot differ.
std::vector<std::string> wordsThatFit(const FuzzySystem& system, const std::string& beginning) {
    try {
        parseRule(system, beginning);
        return {"AND", "WITH"}; // it could be the whole rule; whether it has a weight, the next word tells
    } catch (const RuleError& error) {
        return error.mistake().length == 0 ? error.mistake().alternatives : std::vector<std::string>();
    }
}

} // namespace esm
