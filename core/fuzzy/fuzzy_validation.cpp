#include "core/fuzzy/fuzzy_system.h"
#include "core/fuzzy/implied_set.h"
#include "core/fuzzy/keywords.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace esm {

namespace {

std::string listed(std::initializer_list<double> numbers) {
    std::string text;
    for (const double number : numbers)
        text += (text.empty() ? "" : ", ") + roundedText(number);
    return text;
}

/// Beyond it the square of a width overflows, which the moment of a set takes (centre_of_gravity.cpp).
std::string upToLargest() {
    return " up to " + roundedText(largestNumber);
}

bool isControl(char c) {
    return static_cast<unsigned char>(c) < ' ' || c == 127;
}

bool isThere(const FuzzyProposition& proposition, const std::vector<FuzzyVariable>& variables) {
    return proposition.variable < variables.size() &&
           proposition.term < variables[proposition.variable].terms.size();
}

std::string tooManyWords(std::size_t count) {
    return ": there are " + std::to_string(count) + "; there may be " + std::to_string(mostFuzzyWords);
}

constexpr const char* notThere = ": speaks of a variable or term that is not there";

/// Goes through a system and notes what is wrong with it. Everything, and not the first only: who mends a
/// file by hand sees all at once. Later checks are left out only where they would read beyond what an earlier
/// one found missing.
class SystemCheck {
public:
    explicit SystemCheck(const FuzzySystem& system) : m_system(system) {}

    std::vector<FuzzyProblem> problems() && {
        checkVariables(FuzzyPart::List::Inputs);
        checkVariables(FuzzyPart::List::Outputs);
        for (std::size_t output = 0; output < m_system.outputs.size(); ++output)
            checkOutputSets({FuzzyPart::List::Outputs, output});
        checkRules();
        return std::move(m_problems);
    }

private:
    using List = FuzzyPart::List;

    const std::vector<FuzzyVariable>& variables(List list) const {
        return list == List::Inputs ? m_system.inputs : m_system.outputs;
    }

    static std::string nameOf(List list) { return list == List::Inputs ? "inputs" : "outputs"; }

    void add(const std::string& text) { m_problems.push_back({text, std::nullopt}); }

    /// @param text what follows the part's place
    void add(const FuzzyPart& part, const std::string& text) {
        const FuzzyVariable& variable = variables(part.list)[part.variable];
        std::string place = nameOf(part.list) + "." + variable.name;
        if (part.term) place += ".terms." + variable.terms[*part.term].name;
        m_problems.push_back({place + text, part});
    }

    void checkName(const FuzzyPart& part, const std::string& name) {
        if (const std::string problem = nameProblem(name); !problem.empty()) add(part, ": " + problem);
    }

    void checkIsNew(const FuzzyPart& part, const std::string& name, std::set<std::string>& names) {
        if (!names.insert(name).second) add(part, ": the name is there twice");
    }

    /// Inputs and outputs share their names: values are set and told by name alone.
    void checkVariables(List list) {
        if (variables(list).empty()) add(nameOf(list) + ": there must be at least one");
        if (const std::size_t count = variables(list).size(); count > mostFuzzyWords)
            add(nameOf(list) + tooManyWords(count));
        for (std::size_t i = 0; i < variables(list).size(); ++i) {
            checkVariable({list, i}, variables(list)[i]);
            checkIsNew({list, i}, variables(list)[i].name, m_names);
        }
    }

    void checkVariable(FuzzyPart part, const FuzzyVariable& variable) {
        checkName(part, variable.name);
        const bool hasRange = variable.minimum >= -largestNumber && variable.maximum <= largestNumber &&
                              variable.minimum < variable.maximum;
        if (!hasRange)
            add(part, ".range: must be two finite numbers" + upToLargest() + ", the smaller first, got " +
                          listed({variable.minimum, variable.maximum}));
        if (std::any_of(variable.unit.begin(), variable.unit.end(), isControl))
            add(part, ".unit: must be one line of text");
        if (variable.unit.size() > longestUnit)
            add(part, ".unit: may have " + std::to_string(longestUnit) + " bytes");
        if (variable.terms.empty()) add(part, ".terms: there must be at least one");
        if (const std::size_t count = variable.terms.size(); count > mostFuzzyWords)
            add(part, ".terms" + tooManyWords(count));
        std::set<std::string> names;
        for (std::size_t term = 0; term < variable.terms.size(); ++term) {
            part.term = term;
            checkName(part, variable.terms[term].name);
            checkCorners(part, variable.terms[term].set);
            checkIsNew(part, variable.terms[term].name, names);
        }
    }

    void checkCorners(const FuzzyPart& term, const Trapezoid& set) {
        const auto isBounded = [](double corner) { return std::abs(corner) <= largestNumber; };
        if (!(isBounded(set.a) && isBounded(set.b) && isBounded(set.c) && isBounded(set.d)))
            add(term, ": the corners must be finite numbers" + upToLargest());
        else if (!(set.a <= set.b && set.b <= set.c && set.c <= set.d))
            add(term, ": the corners must rise, got " + listed({set.a, set.b, set.c, set.d}));
    }

    /// A conclusion outside its variable's range would have nothing to take the centre of gravity of; one
    /// that reaches the range in its end point alone, neither area nor the weight of a point.
    void checkOutputSets(FuzzyPart part) {
        const FuzzyVariable& output = m_system.outputs[part.variable];
        for (std::size_t term = 0; term < output.terms.size(); ++term) {
            part.term = term;
            if (!reachesInto(output, implied(output.terms[term].set, 1, TNorm::Minimum)))
                add(part, ": lies outside the output's range");
        }
    }

    /// Too many rules are told by their number alone: to list what is wrong with each would take long and
    /// help nobody.
    void checkRules() {
        if (m_system.rules.size() > mostFuzzyRules) {
            add(tooManyRules(m_system.rules.size()));
            return;
        }
        std::size_t conclusions = 0;
        for (const FuzzyRule& rule : m_system.rules)
            conclusions += rule.conclusions.size();
        if (conclusions > mostFuzzyConclusions)
            add("rules: there are " + std::to_string(conclusions) +
                " conclusions in all; a system may have " + std::to_string(mostFuzzyConclusions));
        for (std::size_t i = 0; i < m_system.rules.size(); ++i)
            checkRule("rules[" + std::to_string(i) + "]", m_system.rules[i]);
    }

    void checkRule(const std::string& place, const FuzzyRule& rule) {
        if (isDeeperThan(deepestCondition, rule.condition))
            add(place + ", condition: is nested deeper than " + std::to_string(deepestCondition));
        else
            checkCondition(place + ", condition", rule.condition);
        if (rule.conclusions.empty()) add(place + ", conclusions: there must be at least one");
        for (const FuzzyProposition& conclusion : rule.conclusions)
            if (!isThere(conclusion, m_system.outputs)) add(place + ", conclusions" + notThere);
        if (!(rule.weight >= 0 && rule.weight <= 1))
            add(place + ", weight: must be a number from 0 to 1, got " + roundedText(rule.weight));
    }

    /// Precondition: the condition is not nested too deeply.
    void checkCondition(const std::string& place, const FuzzyCondition& condition) {
        using Kind = FuzzyCondition::Kind;
        const std::size_t parts = condition.parts.size();
        const bool isJoined = condition.kind == Kind::And || condition.kind == Kind::Or;
        const bool isWhole = isJoined ? parts >= 2 : parts == (condition.kind == Kind::Not ? 1 : 0);
        if (!isWhole) add(place + ": AND and OR join two conditions or more, NOT takes one");
        if (condition.kind == Kind::Is && !isThere(condition.proposition, m_system.inputs))
            add(place + notThere);
        for (const FuzzyCondition& part : condition.parts)
            checkCondition(place, part);
    }

    const FuzzySystem& m_system;
    std::set<std::string> m_names; ///< of inputs and outputs, which share them
    std::vector<FuzzyProblem> m_problems;
};

} // namespace

std::string tooManyRules(std::size_t count) {
    return "rules: there are " + std::to_string(count) + "; a system may have " +
           std::to_string(mostFuzzyRules);
}

std::vector<FuzzyProblem> problemsOf(const FuzzySystem& system) {
    return SystemCheck(system).problems();
}

std::vector<std::string> validate(const FuzzySystem& system) {
    std::vector<std::string> texts;
    for (FuzzyProblem& problem : problemsOf(system))
        texts.push_back(std::move(problem.text));
    return texts;
}

} // namespace esm
