#include "core/exchange/fuzzy/fuzzy_text_writer.h"

#include "core/exchange/fuzzy/fuzzy_identifiers.h"

#include <algorithm>

namespace esm {

void FuzzyTextWriter::head(const FuzzySystem& system, const std::string& keyword) {
    const std::string name = identifierFor(system.name);
    if (name != system.name) line(remark("name", system.name));
    if (!system.description.empty()) line(remark("description", system.description));
    if (!system.note.empty()) line(remark("note", system.note));
    line(keyword + " " + name);
}

std::string FuzzyTextWriter::realName(const std::string& name, const std::string& identifier) const {
    return name == identifier ? "" : " " + remark("name", name);
}

std::string FuzzyTextWriter::unit(const FuzzyVariable& variable) const {
    return variable.unit.empty() ? "" : " " + remark("unit", variable.unit);
}

std::string FuzzyTextWriter::remark(const std::string& key, const std::string& text) const {
    const std::string begun = std::string(m_form.begin) + " " + key + ": " + asRemark(text);
    return m_form.end == "\n" ? begun : begun + " " + std::string(m_form.end);
}

bool hasPointsAlone(const FuzzyVariable& variable) {
    return std::all_of(variable.terms.begin(), variable.terms.end(),
                       [](const FuzzyTerm& term) { return isSinglePoint(term.set); });
}

} // namespace esm
