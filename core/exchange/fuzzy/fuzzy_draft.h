#pragma once

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/exchange/fuzzy/fuzzy_shapes.h"
#include "core/exchange/fuzzy/fuzzy_source.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace esm {

/// As the file calls it; `name` where a remark of ours says what it is really called.
struct DraftName {
    TextWord identifier;
    std::optional<std::string> name = {};
};

struct DraftTerm {
    DraftName name;
    ShapeReading shape;
};

struct DraftVariable {
    DraftName name;
    std::optional<std::pair<double, double>> range = {};
    std::vector<DraftTerm> terms = {};
    std::string unit = {};
    std::optional<TextPlace> meanOfPoints =
        {}; ///< where the file asks for it in place of the centre of gravity
};

struct DraftRule {
    std::vector<TextWord> words; ///< brackets and commas are words of their own
    TextPlace end;
};

/// What a norm is for.
enum class NormUse { Conjunction, Disjunction, Implication, Aggregation };

/// Rules with the norms that stand beside them.
struct DraftRuleBlock {
    std::vector<DraftRule> rules;
    std::vector<std::pair<NormUse, TextWord>> norms; ///< by their names
    std::optional<TextPlace> disabled = {};          ///< where the file says so
};

struct DraftNorms {
    std::optional<TNorm> conjunction, implication;
    std::optional<TConorm> disjunction, aggregation;
};

/// What a text file says of a system, before it is known whether that makes one.
struct FuzzyDraft {
    std::optional<std::string> name;
    std::string description, note;
    std::vector<DraftVariable> inputs, outputs;
    std::vector<DraftRule> rules;
    DraftNorms norms;
    std::vector<std::pair<TextPlace, std::string>> warnings;
    TextPlace end;

    void warn(const TextPlace& place, std::string text) { warnings.emplace_back(place, std::move(text)); }
};

/// Name, description and note from remarks above the first line of code.
void readHead(FuzzyDraft& draft, const std::vector<TextRemark>& remarks, const TextPlace& firstCode);

DraftTerm draftTerm(FuzzyDraft& draft, DraftName name, const std::string& shape,
                    const std::vector<double>& numbers); ///< @throws InvalidModel with the place

/// A norm by its name, unless that says that there is none; a system has one of each, so that the first one
/// counts. @throws InvalidModel
void settleNorm(FuzzyDraft& draft, NormUse use, const TextWord& name);

/// Its rules and norms; neither of a disabled one. @throws InvalidModel
void takeBlock(FuzzyDraft& draft, DraftRuleBlock block);

/// As many as an object of JSON may have members. @throws InvalidModel with the place of one more
void addVariable(std::vector<DraftVariable>& list, DraftVariable variable);
void addTerm(DraftVariable& variable, DraftTerm term);

/// A variable's unit from a remark for it. @throws InvalidModel with the place of one too long to be one
std::optional<std::string> unitFrom(const TextRemark& remark);

double numberAt(const TextWord& word); ///< @throws InvalidModel with the place

/// @throws InvalidModel: what problemsOf() and parseRule() say, with the place
ImportedFuzzySystem finished(FuzzyDraft draft);

} // namespace esm
