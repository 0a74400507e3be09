#include "tests/support/fuzzylite_engine.h"

#include "core/fuzzy/rule_text.h"

#include <fl/Headers.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace {

fl::TNorm* newNorm(esm::TNorm norm) {
    switch (norm) {
    case esm::TNorm::Product:
        return new fl::AlgebraicProduct;
    case esm::TNorm::BoundedDifference:
        return new fl::BoundedDifference;
    default:
        return new fl::Minimum;
    }
}

fl::SNorm* newNorm(esm::TConorm norm) {
    switch (norm) {
    case esm::TConorm::ProbabilisticSum:
        return new fl::AlgebraicSum;
    case esm::TConorm::BoundedSum:
        return new fl::BoundedSum;
    default:
        return new fl::Maximum;
    }
}

template<class Variable> Variable* newVariable(const esm::FuzzyVariable& variable) {
    auto* result = new Variable(variable.name, variable.minimum, variable.maximum);
    for (const auto& [name, set] : variable.terms)
        result->addTerm(new fl::Trapezoid(name, set.a, set.b, set.c, set.d));
    return result;
}

std::string inSmallLetters(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

} // namespace

FuzzyliteEngine::FuzzyliteEngine(const esm::FuzzySystem& system, int resolution)
    : m_engine(std::make_unique<fl::Engine>()) {
    fl::fuzzylite::setMachEps(0); // else it takes small degrees for none
    for (const esm::FuzzyVariable& input : system.inputs)
        m_engine->addInputVariable(newVariable<fl::InputVariable>(input));
    for (const esm::FuzzyVariable& output : system.outputs) {
        auto* variable = newVariable<fl::OutputVariable>(output);
        variable->setAggregation(newNorm(system.norms.aggregation));
        variable->setDefuzzifier(new fl::Centroid(resolution));
        m_engine->addOutputVariable(variable);
    }
    auto* block = new fl::RuleBlock;
    block->setConjunction(newNorm(system.norms.conjunction));
    block->setDisjunction(newNorm(system.norms.disjunction));
    block->setImplication(newNorm(system.norms.implication));
    block->setActivation(new fl::General);
    for (const esm::FuzzyRule& rule : system.rules)
        block->addRule(fl::Rule::parse(inSmallLetters(esm::ruleText(system, rule)), m_engine.get()));
    m_engine->addRuleBlock(block);
}

FuzzyliteEngine::FuzzyliteEngine(std::unique_ptr<fl::Engine> engine) : m_engine(std::move(engine)) {
    fl::fuzzylite::setMachEps(0);
}

FuzzyliteEngine FuzzyliteEngine::fromFll(const std::string& text) {
    return FuzzyliteEngine(std::unique_ptr<fl::Engine>(fl::FllImporter().fromString(text)));
}

FuzzyliteEngine FuzzyliteEngine::fromFcl(const std::string& text, int resolution) {
    std::unique_ptr<fl::Engine> engine(fl::FclImporter().fromString(text));
    for (fl::OutputVariable* output : engine->outputVariables())
        if (auto* defuzzifier = dynamic_cast<fl::IntegralDefuzzifier*>(output->getDefuzzifier()))
            defuzzifier->setResolution(resolution);
    return FuzzyliteEngine(std::move(engine));
}

FuzzyliteEngine::~FuzzyliteEngine() = default;

void FuzzyliteEngine::process(const std::vector<double>& inputs) {
    for (std::size_t i = 0; i < inputs.size(); ++i)
        m_engine->getInputVariable(i)->setValue(inputs[i]);
    m_engine->process();
}

std::vector<std::optional<double>> FuzzyliteEngine::outputs() const {
    std::vector<std::optional<double>> values;
    for (const fl::OutputVariable* output : m_engine->outputVariables()) {
        const double value = output->getValue();
        values.push_back(std::isnan(value) ? std::nullopt : std::optional<double>(value));
    }
    return values;
}
