#include "core/fuzzy/inference.h"

#include "core/support/errors.h"
#include "core/support/joined.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace esm {

namespace {

/// A conclusion's set, cut off at its degree: straight between start, rise, fall and end.
struct ClippedSet {
    double start, rise, fall, end;
    double height;
    double riseWidth, fallWidth; ///< of the whole set, over which its degree goes from 0 to 1 and back
};

ClippedSet clip(const Trapezoid& set, double height) {
    const double riseWidth = set.b - set.a, fallWidth = set.d - set.c;
    const double rise = set.a + height * riseWidth, fall = set.d - height * fallWidth;
    return {set.a, rise, fall, set.d, height, riseWidth, fallWidth};
}

/// A straight piece of a set over one interval.
struct Piece {
    double left, right; ///< degrees at the interval's ends
};

/// The interval lies within the set, and none of the set's bends within the interval.
Piece pieceOver(const ClippedSet& set, double left, double right) {
    if (right <= set.rise) return {(left - set.start) / set.riseWidth, (right - set.start) / set.riseWidth};
    if (left >= set.fall) return {(set.end - left) / set.fallWidth, (set.end - right) / set.fallWidth};
    return {set.height, set.height};
}

/// Area and first moment about an origin, gathered piece by piece.
struct Gravity {
    double origin;
    double area = 0, moment = 0;

    void add(double left, double right, double leftDegree, double rightDegree) {
        const double width = right - left;
        const double pieceArea = 0.5 * width * (leftDegree + rightDegree);
        area += pieceArea;
        moment += pieceArea * (left - origin) + width * width * (leftDegree + 2 * rightDegree) / 6;
    }
};

/// Working memory of one inference, so that its outputs share it.
struct Workspace {
    explicit Workspace(std::size_t mostTerms) {
        degrees.reserve(mostTerms);
        sets.reserve(mostTerms);
        breaks.reserve(4 * mostTerms);
        pieces.reserve(mostTerms);
    }

    std::vector<double> degrees;  ///< per term of the output at hand
    std::vector<ClippedSet> sets; ///< those with a degree above 0
    std::vector<double> breaks;   ///< where a set bends, in rising order
    std::vector<Piece> pieces;    ///< of the sets over the interval at hand
};

/// Adds the upper envelope of the pieces over an interval: follow the highest piece from the left and change
/// to the steeper one that crosses it first.
void addEnvelope(Gravity& gravity, const std::vector<Piece>& pieces, double left, double right) {
    const auto isLower = [](const Piece& p, const Piece& q) {
        return p.left < q.left || (p.left == q.left && p.right < q.right);
    };
    const Piece* highest = &*std::max_element(pieces.begin(), pieces.end(), isLower);
    double x = left, degree = highest->left;
    for (;;) {
        const Piece* next = nullptr;
        double firstCrossing = 1; // as a part of the interval
        for (const Piece& piece : pieces) {
            const double rising = (piece.right - piece.left) - (highest->right - highest->left);
            if (piece.right <= highest->right || rising <= 0) continue;
            const double crossing = (highest->left - piece.left) / rising;
            if (crossing > firstCrossing || (crossing == firstCrossing && next && piece.right <= next->right))
                continue;
            firstCrossing = crossing;
            next = &piece;
        }
        if (!next) break;
        const double crossingX = left + firstCrossing * (right - left);
        const double crossingDegree = highest->left + firstCrossing * (highest->right - highest->left);
        gravity.add(x, crossingX, degree, crossingDegree);
        x = crossingX;
        degree = crossingDegree;
        highest = next;
    }
    gravity.add(x, right, degree, highest->right);
}

void sortNearlySorted(std::vector<double>& values) {
    for (std::size_t i = 1; i < values.size(); ++i)
        for (std::size_t j = i; j > 0 && values[j] < values[j - 1]; --j)
            std::swap(values[j], values[j - 1]);
}

/// Where every set is a single point there is no area: the points' mean, weighted by their degrees, which is
/// what the centre of gravity tends to as equally wide sets shrink.
double centreOfPoints(const std::vector<ClippedSet>& sets) {
    double weight = 0, moment = 0;
    for (const ClippedSet& set : sets) {
        weight += set.height;
        moment += set.height * 0.5 * (set.start + set.end);
    }
    return moment / weight;
}

/// Centre of gravity of the maximum of the sets over the variable's range; empty when none has a degree.
std::optional<double> defuzzify(const FuzzyVariable& variable, Workspace& work) {
    work.sets.clear();
    work.breaks.clear();
    for (std::size_t term = 0; term < variable.terms.size(); ++term) {
        if (!(work.degrees[term] > 0)) continue;
        const ClippedSet set = clip(variable.terms[term].set, work.degrees[term]);
        work.sets.push_back(set);
        for (const double x : {set.start, set.rise, set.fall, set.end})
            work.breaks.push_back(std::clamp(x, variable.minimum, variable.maximum));
    }
    if (work.sets.empty()) return std::nullopt;
    sortNearlySorted(work.breaks);

    Gravity gravity{work.breaks.front()};
    for (std::size_t i = 1; i < work.breaks.size(); ++i) {
        const double left = work.breaks[i - 1], right = work.breaks[i];
        if (!(left < right)) continue;
        work.pieces.clear();
        for (const ClippedSet& set : work.sets)
            if (set.start <= left && set.end >= right) work.pieces.push_back(pieceOver(set, left, right));
        if (work.pieces.size() == 1)
            gravity.add(left, right, work.pieces[0].left, work.pieces[0].right);
        else if (!work.pieces.empty())
            addEnvelope(gravity, work.pieces, left, right);
    }
    const double centre =
        gravity.area > 0 ? gravity.origin + gravity.moment / gravity.area : centreOfPoints(work.sets);
    return std::clamp(centre, work.breaks.front(), work.breaks.back());
}

double firingDegree(const FuzzySystem& system, const FuzzyRule& rule,
                    const std::vector<std::optional<double>>& inputs) {
    double degree = 1;
    for (const FuzzyProposition& condition : rule.conditions) {
        const std::optional<double>& value = inputs[condition.variable];
        if (!value) return 0;
        degree =
            std::min(degree, membership(system.inputs[condition.variable].terms[condition.term].set, *value));
    }
    return degree;
}

std::size_t mostTerms(const std::vector<FuzzyVariable>& variables) {
    std::size_t most = 0;
    for (const FuzzyVariable& variable : variables)
        most = std::max(most, variable.terms.size());
    return most;
}

} // namespace

InferenceResult infer(const FuzzySystem& system, const std::vector<std::optional<double>>& inputs) {
    InferenceResult result;
    result.firing.reserve(system.rules.size());
    for (const FuzzyRule& rule : system.rules)
        result.firing.push_back(firingDegree(system, rule, inputs));

    Workspace work(mostTerms(system.outputs));
    result.outputs.reserve(system.outputs.size());
    for (std::size_t output = 0; output < system.outputs.size(); ++output) {
        const FuzzyVariable& variable = system.outputs[output];
        work.degrees.assign(variable.terms.size(), 0);
        for (std::size_t rule = 0; rule < system.rules.size(); ++rule)
            for (const FuzzyProposition& conclusion : system.rules[rule].conclusions)
                if (conclusion.variable == output)
                    work.degrees[conclusion.term] =
                        std::max(work.degrees[conclusion.term], result.firing[rule]);
        result.outputs.push_back(defuzzify(variable, work));
    }
    return result;
}

std::vector<std::optional<double>> orderedInputs(const FuzzySystem& system, const NamedValues& values) {
    std::vector<std::optional<double>> ordered(system.inputs.size());
    std::vector<std::string> problems;
    for (const auto& [name, value] : values) {
        const auto input = std::find_if(system.inputs.begin(), system.inputs.end(),
                                        [&name = name](const FuzzyVariable& v) { return v.name == name; });
        if (input == system.inputs.end())
            problems.push_back("there is no input \"" + name + "\"; the inputs are " +
                               joinedNames(system.inputs));
        else if (!std::isfinite(value))
            problems.push_back("the input " + name + " is not a finite number");
        else
            ordered[static_cast<std::size_t>(input - system.inputs.begin())] = value;
    }
    if (!problems.empty()) throw InvalidModel(problems);
    return ordered;
}

std::string inWords(const FuzzyVariable& variable, double value) {
    std::vector<std::pair<double, const std::string*>> degrees;
    for (const FuzzyTerm& term : variable.terms)
        if (const double degree = membership(term.set, value); degree >= 0.005)
            degrees.emplace_back(degree, &term.name);
    std::stable_sort(degrees.begin(), degrees.end(),
                     [](const auto& p, const auto& q) { return p.first > q.first; });
    std::string words;
    for (const auto& [degree, name] : degrees) {
        char number[16];
        std::snprintf(number, sizeof number, "%.2f", degree);
        if (!words.empty()) words += ", ";
        words.append(*name).append(" ").append(number);
    }
    return words.empty() ? "none" : words;
}

} // namespace esm
