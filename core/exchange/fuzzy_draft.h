#pragma once

#include "core/exchange/fuzzy_file.h"
#include "core/exchange/fuzzy_shapes.h"
#include "core/exchange/fuzzy_source.h"

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
void settleNorm(FuzzyDraft& draft, std::optional<TNorm>& norm, const TextWord& name);
void settleNorm(FuzzyDraft& draft, std::optional<TConorm>& norm, const TextWord& name);

double numberAt(const TextWord& word); ///< @throws InvalidModel with the place

/// @throws InvalidModel: what validate() and parseRule() say, with the place
ImportedFuzzySystem finished(FuzzyDraft draft);

} // namespace esm
