#include "core/fuzzy/inverse.h"

#include <cmath>

namespace esm {

namespace {

using Inputs = std::vector<std::optional<double>>;

/// An output's excess over what is wanted, along one input. None where no rule reaches it.
class Excess {
public:
    Excess(const FuzzySystem& system, Inputs inputs, std::size_t input, std::size_t output, double wanted)
        : m_system(system), m_inputs(std::move(inputs)), m_input(input), m_output(output), m_wanted(wanted) {}

    std::optional<double> at(double value) {
        m_inputs[m_input] = value;
        const std::optional<double> result = infer(m_system, m_inputs).outputs[m_output];
        return result ? std::optional(*result - m_wanted) : std::nullopt;
    }

private:
    const FuzzySystem& m_system;
    Inputs m_inputs;
    std::size_t m_input, m_output;
    double m_wanted;
};

/// Between two values where the excess has other signs; nothing where it jumps to none on the way.
std::optional<double> crossing(Excess& excess, double from, double to) {
    const bool isBelow = *excess.at(from) < 0;
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = (from + to) / 2;
        const auto value = excess.at(middle);
        if (!value) return std::nullopt;
        ((*value < 0) == isBelow ? from : to) = middle;
    }
    return to;
}

} // namespace

// Rules may make of an output any curve over an input, so that a slope to follow is not to be had. A thousand
// places are finer than any slider; the interval in which the excess changes its sign is then halved. Where
// the curve jumps over what is wanted, halving ends at the jump, which is not taken for it.
std::optional<ReachingInput> reachingInput(const FuzzySystem& system, const Inputs& inputs,
                                           std::size_t output, double wanted) {
    constexpr int places = 1000;
    const double near = 1e-6 * std::abs(wanted);
    for (std::size_t input = 0; input < system.inputs.size(); ++input) {
        const FuzzyVariable& variable = system.inputs[input];
        Excess excess(system, inputs, input, output, wanted);
        const auto place = [&](int i) {
            return variable.minimum + (variable.maximum - variable.minimum) * i / places;
        };
        std::optional<double> last;
        for (int i = 0; i <= places; ++i) {
            const auto value = excess.at(place(i));
            if (value && std::abs(*value) <= near) return ReachingInput{input, place(i)};
            const bool crosses = value && last && (*value < 0) != (*last < 0);
            const auto found = crosses ? crossing(excess, place(i - 1), place(i)) : std::nullopt;
            if (found && std::abs(excess.at(*found).value_or(wanted)) <= near)
                return ReachingInput{input, *found};
            last = value;
        }
    }
    return std::nullopt;
}

} // namespace esm
