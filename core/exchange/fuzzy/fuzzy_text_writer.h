#pragma once

#include "core/exchange/fuzzy/fuzzy_source.h"
#include "core/fuzzy/fuzzy_system.h"

namespace esm {

/// The text of a system in another language as it grows line by line, with what the language has no words for
/// in remarks.
class FuzzyTextWriter {
public:
    /// @param form of a remark; one that ends with its line has "\n" for its end
    explicit FuzzyTextWriter(const RemarkForm& form) : m_form(form) {}

    void line(const std::string& text) { m_text.append(text).append("\n"); }
    /// What is said of the system as a whole, and the line that begins it under its name.
    void head(const FuzzySystem& system, const std::string& keyword);
    std::string takeText() { return std::move(m_text); }

    /// Behind a declaration whose name is really another one.
    std::string realName(const std::string& name, const std::string& identifier) const;
    std::string unit(const FuzzyVariable& variable) const;

private:
    std::string remark(const std::string& key, const std::string& text) const;

    RemarkForm m_form;
    std::string m_text;
};

/// Whether all terms of a variable are single points.
bool hasPointsAlone(const FuzzyVariable& variable);

} // namespace esm
