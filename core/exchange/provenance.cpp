#include "core/exchange/provenance.h"

#include "core/support/offenders.h"
#include "core/support/text_line.h"

#include <chrono>

namespace esm {

namespace {

/// Whether it is 2026, 2026-05 or 2026-05-17, as ISO 8601 and XMP write dates, and in the calendar.
bool isDate(const std::string& text) {
    constexpr std::string_view form = "0000-00-00";
    if (text.size() != 4 && text.size() != 7 && text.size() != form.size()) return false;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (form[i] == '-' ? text[i] != '-' : text[i] < '0' || text[i] > '9') return false;
    const auto part = [&](std::size_t begin, std::size_t size) {
        return text.size() > begin ? std::stoi(text.substr(begin, size)) : 1;
    };
    const std::chrono::year_month_day day{std::chrono::year(part(0, 4)),
                                          std::chrono::month(static_cast<unsigned>(part(5, 2))),
                                          std::chrono::day(static_cast<unsigned>(part(8, 2)))};
    return day.ok();
}

} // namespace

std::vector<std::string> validate(const Authorship& authorship) {
    std::vector<std::string> problems;
    forEachField(fieldsOf<Authorship>, [&](const auto& field) {
        const std::string problem = lineProblem(authorship.*field.member, longestStatement);
        if (!problem.empty()) problems.push_back(std::string("the ") + field.key + " " + problem);
    });
    if (!authorship.date.empty() && !isDate(authorship.date))
        problems.emplace_back("the date must be a year, a month or a day, as 2026, 2026-05 or 2026-05-17");
    return problems;
}

std::vector<std::string> validate(const Provenance& provenance) {
    std::vector<std::string> problems = validate(provenance.authorship);
    if (const std::string problem = lineProblem(provenance.program, longestStatement); !problem.empty())
        problems.push_back("the program " + problem);
    if (provenance.source) addUnder(problems, "source", validate(*provenance.source));
    return problems;
}

} // namespace esm
