#pragma once

#include <vector>

namespace esm {

/// A word of a row: where its middle should be and how wide it is, pixels.
struct PlacedWord {
    double middle, width;
};

/// Left ends for words in a row from 0 to `length`, at least `gap` apart: each as near to its place as the
/// others let it, by the least sum of squares. Precondition: the middles rise, and all words fit.
std::vector<double> spreadWords(const std::vector<PlacedWord>& words, double length, double gap);

} // namespace esm
