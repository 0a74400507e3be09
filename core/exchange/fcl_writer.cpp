#include "core/exchange/fcl_file.h"
#include "core/exchange/fuzzy_identifiers.h"
#include "core/exchange/fuzzy_norm_names.h"
#include "core/exchange/fuzzy_shapes.h"
#include "core/exchange/fuzzy_source.h"
#include "core/fuzzy/rule_text.h"
#include "core/support/numbers.h"

#include <algorithm>

namespace esm {

namespace {

const std::vector<std::string>& fclReservedWords() {
    static const std::vector<std::string> words{"function_block",
                                                "end_function_block",
                                                "var",
                                                "var_input",
                                                "var_output",
                                                "end_var",
                                                "fuzzify",
                                                "end_fuzzify",
                                                "defuzzify",
                                                "end_defuzzify",
                                                "ruleblock",
                                                "end_ruleblock",
                                                "options",
                                                "end_options",
                                                "term",
                                                "range",
                                                "method",
                                                "accu",
                                                "act",
                                                "default",
                                                "rule",
                                                "real",
                                                "cog",
                                                "cogs",
                                                "nc",
                                                "min",
                                                "max",
                                                "prod",
                                                "bdif",
                                                "asum",
                                                "bsum",
                                                "true",
                                                "false",
                                                "lock",
                                                "enabled",
                                                "with",
                                                "if",
                                                "is",
                                                "not",
                                                "and",
                                                "or",
                                                "then"};
    return words;
}

std::string fclRemark(const std::string& key, const std::string& text) {
    return "(* " + key + ": " + asRemark(text) + " *)";
}

/// Behind a declaration whose name is really another one.
std::string realNameRemark(const std::string& name, const std::string& identifier) {
    return name == identifier ? "" : " " + fclRemark("name", name);
}

std::string unitRemark(const FuzzyVariable& variable) {
    return variable.unit.empty() ? "" : " " + fclRemark("unit", variable.unit);
}

std::string setPoint(double x, int degree) {
    return " (" + exactText(x) + ", " + std::to_string(degree) + ")";
}

/// Beyond its first and last point a set goes on as it is there: a shoulder at the end of the range has no
/// foot.
std::string fclSet(const FuzzyVariable& variable, const Trapezoid& set) {
    if (isSinglePoint(set)) return " " + exactText(set.a);
    std::string text;
    if (set.a < set.b || set.a > variable.minimum) text += setPoint(set.a, 0);
    text += setPoint(set.b, 1);
    if (set.b < set.c) text += setPoint(set.c, 1);
    if (set.c < set.d || set.d < variable.maximum) text += setPoint(set.d, 0);
    return text;
}

std::string rangeText(const FuzzyVariable& variable) {
    return "(" + exactText(variable.minimum) + " .. " + exactText(variable.maximum) + ")";
}

/// Writes the identified system; the original says what names really are.
class FclWriter {
public:
    FclWriter(const FuzzySystem& original, const FuzzySystem& system)
        : m_original(original), m_system(system) {}

    std::string write() {
        head();
        declarations();
        for (std::size_t i = 0; i < m_system.inputs.size(); ++i) {
            line("\nFUZZIFY " + m_system.inputs[i].name);
            terms(m_original.inputs[i], m_system.inputs[i]);
            line("END_FUZZIFY");
        }
        for (std::size_t i = 0; i < m_system.outputs.size(); ++i)
            defuzzify(m_original.outputs[i], m_system.outputs[i]);
        rules();
        line("\nEND_FUNCTION_BLOCK");
        return std::move(m_text);
    }

private:
    void line(const std::string& text) { m_text.append(text).append("\n"); }

    void head() {
        const std::string name = identifierFor(m_original.name);
        if (name != m_original.name) line(fclRemark("name", m_original.name));
        if (!m_original.description.empty()) line(fclRemark("description", m_original.description));
        if (!m_original.note.empty()) line(fclRemark("note", m_original.note));
        line("FUNCTION_BLOCK " + name);
    }

    void declarations() {
        line("\nVAR_INPUT");
        for (std::size_t i = 0; i < m_system.inputs.size(); ++i) {
            const FuzzyVariable& input = m_system.inputs[i];
            line("  " + input.name + " : REAL; (* RANGE" + rangeText(input) + " *)" + unitRemark(input) +
                 realNameRemark(m_original.inputs[i].name, input.name));
        }
        line("END_VAR\n\nVAR_OUTPUT");
        for (std::size_t i = 0; i < m_system.outputs.size(); ++i) {
            const FuzzyVariable& output = m_system.outputs[i];
            line("  " + output.name + " : REAL;" + unitRemark(output) +
                 realNameRemark(m_original.outputs[i].name, output.name));
        }
        line("END_VAR");
    }

    void terms(const FuzzyVariable& original, const FuzzyVariable& variable) {
        for (std::size_t t = 0; t < variable.terms.size(); ++t) {
            const auto& [name, set] = variable.terms[t];
            line("  TERM " + name + " :=" + fclSet(variable, set) + ";" +
                 realNameRemark(original.terms[t].name, name));
        }
    }

    void defuzzify(const FuzzyVariable& original, const FuzzyVariable& output) {
        const bool hasPoints = std::all_of(output.terms.begin(), output.terms.end(),
                                           [](const FuzzyTerm& term) { return isSinglePoint(term.set); });
        line("\nDEFUZZIFY " + output.name);
        line("  RANGE := " + rangeText(output) + ";");
        terms(original, output);
        line(std::string("  METHOD : ") + (hasPoints ? "COGS;" : "COG;"));
        line("END_DEFUZZIFY");
    }

    void rules() {
        const FuzzyNorms& norms = m_system.norms;
        line("\nRULEBLOCK rules");
        line(std::string("  AND : ") + foreignNames(norms.conjunction).fcl + ";");
        line(std::string("  OR : ") + foreignNames(norms.disjunction).fcl + ";");
        line(std::string("  ACT : ") + foreignNames(norms.implication).fcl + ";");
        line(std::string("  ACCU : ") + foreignNames(norms.aggregation).fcl + ";");
        for (std::size_t i = 0; i < m_system.rules.size(); ++i)
            line("  RULE " + std::to_string(i + 1) + " : " + ruleText(m_system, m_system.rules[i]) + ";");
        line("END_RULEBLOCK");
    }

    const FuzzySystem &m_original, &m_system;
    std::string m_text;
};

} // namespace

ExportedFuzzySystem toFcl(const FuzzySystem& system) {
    IdentifiedSystem identified = withIdentifiers(system, fclReservedWords());
    std::vector<std::string>& warnings = identified.warnings;
    if (system.norms.implication == TNorm::BoundedDifference)
        warnings.emplace_back(
            "ACT : BDIF is not of IEC 61131-7, which has MIN and PROD; other programs may refuse it");
    if (system.norms.aggregation == TConorm::ProbabilisticSum)
        warnings.emplace_back(
            "ACCU : ASUM is not of IEC 61131-7, which has MAX and BSUM; other programs may refuse it");
    return {FclWriter(system, identified.system).write(), std::move(warnings)};
}

} // namespace esm
