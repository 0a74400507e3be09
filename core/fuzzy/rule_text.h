#pragma once

#include "core/fuzzy/fuzzy_system.h"
#include "core/support/errors.h"

namespace esm {

/// Where a rule cannot be read: what an editor needs to underline the place and to offer what fits there.
struct RuleMistake {
    std::size_t column = 1; ///< in letters, from 1; behind the last one where the rule ends too early
    std::size_t length = 0; ///< in letters, of the word that does not fit; 0 where the rule ends too early
    /// Keywords, names and brackets that fit there. Not the end of the rule, nor a weight.
    std::vector<std::string> alternatives;
};

/// The message names the column and what was expected.
class RuleError : public InvalidModel {
public:
    RuleError(std::string problem, RuleMistake mistake)
        : InvalidModel("column " + std::to_string(mistake.column) + ": " + problem),
          m_problem(std::move(problem)), m_mistake(std::move(mistake)) {}

    const std::string& problem() const { return m_problem; } ///< without the column
    const RuleMistake& mistake() const { return m_mistake; }

private:
    std::string m_problem;
    RuleMistake m_mistake;
};

/// "IF age IS old AND (zeal IS much OR zeal IS NOT little) THEN viscosity IS thick WITH 0.5". Brackets stand
/// only where they are needed: NOT binds tighter than AND, AND tighter than OR. Precondition: the rule is
/// valid.
std::string ruleText(const FuzzySystem& system, const FuzzyRule& rule);

/// Reads a rule in the form that ruleText() writes, and with more brackets; keywords in any case.
/// @throws RuleError
FuzzyRule parseRule(const FuzzySystem& system, const std::string& text);

} // namespace esm
