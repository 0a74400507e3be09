#include "core/fuzzy/output_response.h"

#include "core/fuzzy/inference_steps.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// For what bends between corners: the centre of gravity is curved even where all sets are straight.
constexpr std::size_t evenSteps = 128;
/// Beside a corner and not only at it: a set that begins upright jumps there, and the value at the corner
/// belongs to one side alone.
constexpr double besideCorner = 1e-9; ///< of the input's range
/// Of the input's range: what rises within it is a jump. Twice the way beside a corner, so that places on
/// both sides of a corner are not parted further.
constexpr double finestStep = 2e-9;
constexpr double smallestRise = 0.01;    ///< of the output's range: 2 pixels of a drawing 200 high
constexpr std::size_t mostPoints = 6000; ///< of a curve; behind them only what is asked for in any case

/// Infers one output again and again: only by the rules that speak of it, in memory that stays. A curve asks
/// up to 6000 times, a map 4096 times.
class OutputInference {
public:
    OutputInference(const FuzzySystem& system, std::size_t output)
        : m_system(system), m_output(output), m_firing(system.rules.size(), 0),
          m_work(workingMemory(system)) {
        for (std::size_t rule = 0; rule < system.rules.size(); ++rule) {
            const auto& conclusions = system.rules[rule].conclusions;
            if (std::any_of(conclusions.begin(), conclusions.end(),
                            [&](const FuzzyProposition& c) { return c.variable == m_output; }))
                m_rules.push_back(rule);
        }
    }

    std::optional<double> value(const std::vector<std::optional<double>>& inputs) {
        for (const std::size_t rule : m_rules)
            m_firing[rule] =
                firingOf(m_system.rules[rule], degreeOf(m_system.rules[rule].condition, m_system, inputs));
        collectSets(m_work, m_system, m_output, m_firing);
        return centreOfGravity(m_system.outputs[m_output], m_system.norms.aggregation, m_work);
    }

private:
    const FuzzySystem& m_system;
    std::size_t m_output;
    std::vector<std::size_t> m_rules;
    std::vector<double> m_firing;
    OutputSets m_work;
};

/// Where a curve is asked for in any case, from left to right.
std::vector<double> placesOn(const FuzzyVariable& input) {
    const double range = input.maximum - input.minimum, beside = besideCorner * range;
    std::vector<double> places;
    for (std::size_t i = 0; i <= evenSteps; ++i)
        places.push_back(input.minimum + static_cast<double>(i) / evenSteps * range);
    for (const FuzzyTerm& term : input.terms)
        for (const double corner : {term.set.a, term.set.b, term.set.c, term.set.d})
            for (const double x : {corner - beside, corner, corner + beside})
                if (x >= input.minimum && x <= input.maximum) places.push_back(x);
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

/// Draws a curve from left to right.
class CurveTracer {
public:
    CurveTracer(const FuzzySystem& system, const ResponseQuestion& question, std::size_t input,
                const Progress& progress)
        : m_inference(system, question.output), m_inputs(question.inputs), m_input(input),
          m_range(system.inputs[input]), m_progress(progress),
          m_rise(smallestRise *
                 (system.outputs[question.output].maximum - system.outputs[question.output].minimum)) {}

    void goTo(double x) {
        const Place place = placeAt(x);
        if (m_last)
            goTo(*m_last, place);
        else
            add(place, false);
    }

    ResponseCurve curve() && { return std::move(m_curve); }

private:
    struct Place {
        double x;
        std::optional<double> y;
    };

    double width() const { return m_range.maximum - m_range.minimum; }

    Place placeAt(double x) {
        reportProgress(m_progress, (x - m_range.minimum) / width());
        m_inputs[m_input] = x;
        ++m_points;
        return {x, m_inference.value(m_inputs)};
    }

    /// Halves the way between two places until the value between them rises by no more than a hundredth of
    /// the range: as many points as the curve needs where it is steep, and few where it is flat. A rise that
    /// is still there in the finest step is a jump, at which the line breaks. Once there are points enough,
    /// nothing is halved further, and what lies between two places is taken for joined. Recursion goes at
    /// most log₂(1 / (128 · finest step)) = 22 levels deep.
    void goTo(const Place& left, const Place& right) {
        const bool isWhole = m_points >= mostPoints;
        const bool isNarrow = right.x - left.x <= finestStep * width();
        const bool isJoined =
            left.y && right.y && ((isWhole && !isNarrow) || std::abs(*right.y - *left.y) <= m_rise);
        const bool isGap = !left.y && !right.y;
        if (isJoined || isGap || isWhole || isNarrow) {
            add(right, isJoined);
            return;
        }
        const Place middle = placeAt(left.x + 0.5 * (right.x - left.x));
        goTo(left, middle);
        goTo(middle, right);
    }

    void add(const Place& place, bool isJoined) {
        m_last = place;
        if (!place.y) return;
        if (!isJoined) m_curve.emplace_back();
        m_curve.back().push_back({place.x, *place.y});
    }

    OutputInference m_inference;
    std::vector<std::optional<double>> m_inputs;
    std::size_t m_input;
    const FuzzyVariable& m_range;
    const Progress& m_progress;
    double m_rise;
    std::size_t m_points = 0;
    std::optional<Place> m_last;
    ResponseCurve m_curve;
};

} // namespace

ResponseCurve responseCurve(const FuzzySystem& system, const ResponseQuestion& question, std::size_t input,
                            const Progress& progress) {
    CurveTracer tracer(system, question, input, progress);
    for (const double place : placesOn(system.inputs[input]))
        tracer.goTo(place);
    return std::move(tracer).curve();
}

/// In cells of one size and not refined as a curve is: a map is looked at as a whole, and its price is known
/// beforehand.
ResponseMap responseMap(const FuzzySystem& system, const ResponseQuestion& question, const MapInputs& inputs,
                        std::size_t cells, const Progress& progress) {
    const auto middle = [&](std::size_t input, std::size_t cell) {
        const FuzzyVariable& range = system.inputs[input];
        const double share = (static_cast<double>(cell) + 0.5) / static_cast<double>(cells);
        return range.minimum + share * (range.maximum - range.minimum);
    };
    OutputInference inference(system, question.output);
    std::vector<std::optional<double>> values = question.inputs;
    ResponseMap map{cells, {}};
    const auto count = static_cast<double>(cells * cells);
    for (std::size_t row = 0; row < cells; ++row) {
        values[inputs.up] = middle(inputs.up, row);
        for (std::size_t column = 0; column < cells; ++column) {
            reportProgress(progress, static_cast<double>(map.values.size()) / count);
            values[inputs.across] = middle(inputs.across, column);
            map.values.push_back(inference.value(values));
        }
    }
    return map;
}

/// The centre of gravity of one term alone bounds what its rules can give, and mixtures of terms mostly lie
/// between those. The whole range would be a poor scale: a centre of gravity hardly ever comes near its ends.
std::pair<double, double> usualValues(const FuzzySystem& system, std::size_t output) {
    const FuzzyVariable& variable = system.outputs[output];
    OutputSets work = workingMemory(system);
    double low = variable.maximum, high = variable.minimum;
    for (const FuzzyRule& rule : system.rules)
        for (const FuzzyProposition& conclusion : rule.conclusions) {
            if (conclusion.variable != output) continue;
            // What a weak rule leaves of a lopsided term lies elsewhere than what a strong one does.
            for (const double degree : {1e-3, 1.0}) {
                const auto set = concludedSet(system, conclusion, degree);
                work.sets.clear();
                if (set) work.sets.push_back(*set);
                const auto value = centreOfGravity(variable, system.norms.aggregation, work);
                low = std::min(low, value.value_or(low));
                high = std::max(high, value.value_or(high));
            }
        }
    if (low < high) return {low, high};
    return {variable.minimum, variable.maximum};
}

} // namespace esm
