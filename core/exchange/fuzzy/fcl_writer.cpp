#include "core/exchange/fuzzy/fcl_file.h"
#include "core/exchange/fuzzy/fuzzy_identifiers.h"
#include "core/exchange/fuzzy/fuzzy_norm_names.h"
#include "core/exchange/fuzzy/fuzzy_text_writer.h"
#include "core/fuzzy/rule_text.h"
#include "core/support/numbers.h"

namespace esm {

namespace {

constexpr const char* fclReservedWords =
    "function_block end_function_block var var_input var_output end_var fuzzify end_fuzzify defuzzify "
    "end_defuzzify ruleblock end_ruleblock options end_options term range method accu act default rule real "
    "cog cogs nc min max prod bdif asum bsum true false lock enabled with if is not and or then";

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

class FclWriter {
public:
    explicit FclWriter(const FuzzySystem& original)
        : m_original(original), m_identified(withIdentifiers(original, fclReservedWords)),
          m_system(m_identified.system) {}

    ExportedFuzzySystem write() {
        m_text.head(m_original, "FUNCTION_BLOCK");
        declarations();
        for (std::size_t i = 0; i < m_system.inputs.size(); ++i) {
            m_text.line("\nFUZZIFY " + m_system.inputs[i].name);
            terms(m_original.inputs[i], m_system.inputs[i]);
            m_text.line("END_FUZZIFY");
        }
        for (std::size_t i = 0; i < m_system.outputs.size(); ++i)
            defuzzify(m_original.outputs[i], m_system.outputs[i]);
        rules();
        m_text.line("\nEND_FUNCTION_BLOCK");
        warnOfNorms();
        return {m_text.takeText(), std::move(m_identified.warnings)};
    }

private:
    void declarations() {
        m_text.line("\nVAR_INPUT");
        for (std::size_t i = 0; i < m_system.inputs.size(); ++i) {
            const FuzzyVariable& input = m_system.inputs[i];
            m_text.line("  " + input.name + " : REAL; (* RANGE" + rangeText(input) + " *)" +
                        m_text.unit(input) + m_text.realName(m_original.inputs[i].name, input.name));
        }
        m_text.line("END_VAR\n\nVAR_OUTPUT");
        for (std::size_t i = 0; i < m_system.outputs.size(); ++i) {
            const FuzzyVariable& output = m_system.outputs[i];
            m_text.line("  " + output.name + " : REAL;" + m_text.unit(output) +
                        m_text.realName(m_original.outputs[i].name, output.name));
        }
        m_text.line("END_VAR");
    }

    void terms(const FuzzyVariable& original, const FuzzyVariable& variable) {
        for (std::size_t t = 0; t < variable.terms.size(); ++t) {
            const auto& [name, set] = variable.terms[t];
            m_text.line("  TERM " + name + " :=" + fclSet(variable, set) + ";" +
                        m_text.realName(original.terms[t].name, name));
        }
    }

    void defuzzify(const FuzzyVariable& original, const FuzzyVariable& output) {
        m_text.line("\nDEFUZZIFY " + output.name);
        m_text.line("  RANGE := " + rangeText(output) + ";");
        terms(original, output);
        m_text.line(std::string("  METHOD : ") + (hasPointsAlone(output) ? "COGS;" : "COG;"));
        m_text.line("END_DEFUZZIFY");
    }

    void rules() {
        const FuzzyNorms& norms = m_system.norms;
        m_text.line("\nRULEBLOCK rules");
        m_text.line(std::string("  AND : ") + foreignNames(norms.conjunction).fcl + ";");
        m_text.line(std::string("  OR : ") + foreignNames(norms.disjunction).fcl + ";");
        m_text.line(std::string("  ACT : ") + foreignNames(norms.implication).fcl + ";");
        m_text.line(std::string("  ACCU : ") + foreignNames(norms.aggregation).fcl + ";");
        for (std::size_t i = 0; i < m_system.rules.size(); ++i)
            m_text.line("  RULE " + std::to_string(i + 1) + " : " + ruleText(m_system, m_system.rules[i]) +
                        ";");
        m_text.line("END_RULEBLOCK");
    }

    void warnOfNorms() {
        if (m_system.norms.implication == TNorm::BoundedDifference)
            m_identified.warnings.emplace_back(
                "ACT : BDIF is not of IEC 61131-7, which has MIN and PROD; other programs may refuse it");
        if (m_system.norms.aggregation == TConorm::ProbabilisticSum)
            m_identified.warnings.emplace_back(
                "ACCU : ASUM is not of IEC 61131-7, which has MAX and BSUM; other programs may refuse it");
    }

    const FuzzySystem& m_original; ///< says what names really are
    IdentifiedSystem m_identified;
    const FuzzySystem& m_system; ///< that is written: the identified one
    FuzzyTextWriter m_text{{"(*", "*)"}};
};

} // namespace

ExportedFuzzySystem toFcl(const FuzzySystem& system) {
    return FclWriter(system).write();
}

} // namespace esm
