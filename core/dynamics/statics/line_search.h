#pragma once

#include <functional>
#include <optional>

namespace esm {

/// A potential at a place of a way, and how it changes along the way there, per whole way.
struct OnWay {
    double value;
    double slope;
};

/// How much of a way to go, from above 0 to 1, so that a potential is lower there and its slope is spent.
/// None where no such place is found.
/// @param start whose slope is below 0
/// @param at the potential at a part of the way; its slope may jump in its own slope, not in its value
std::optional<double> lowerPart(const OnWay& start, const std::function<OnWay(double part)>& at);

} // namespace esm
