#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <array>

namespace esm {

/// The corners of a trapezoid, in their order.
enum class Corner { A, B, C, D };
inline constexpr std::array<Corner, 4> everyCorner{Corner::A, Corner::B, Corner::C, Corner::D};

double cornerOf(const Trapezoid& set, Corner corner);

/// The set with one corner as near to `value` as its neighbours and the variable's range let it: corners
/// never cross.
Trapezoid withCorner(const FuzzyVariable& variable, std::size_t term, Corner corner, double value);

/// The set shifted as a whole as far as the variable's range lets it. A corner at an end of the range that
/// makes a shoulder there stays.
Trapezoid shifted(const FuzzyVariable& variable, std::size_t term, double by);

/// What attracts a corner that is dragged.
struct Snapping {
    double reach; ///< how far off another term's corner or an end of the range still attracts
    double step;  ///< elsewhere, multiples of this; 0 lets every value be
};

/// The value that a corner dragged to `value` snaps to: the nearest end of the range or corner of another
/// term within reach, else a round one.
double snapped(const FuzzyVariable& variable, std::size_t term, double value, const Snapping& snapping);

/// 1, 2 or 5 times a power of ten: the smallest that is not below `least`, which is above 0.
double roundStep(double least);

/// The terms in their order evenly over the range: each core and each flank between two cores has the same
/// width, neighbours overlap by half, the first and the last are shoulders.
std::vector<FuzzyTerm> evenPartition(const FuzzyVariable& variable);

/// The terms where they are, each falling flank drawn over the next one's rising flank, so that degrees add
/// up to 1 everywhere; the lowest and the highest become shoulders. Cores stay where they leave room for
/// flanks. Next is what lies next, whatever the order of the terms.
/// @throws InvalidModel where two terms have their middle at the same place
std::vector<FuzzyTerm> overlappedByHalf(const FuzzyVariable& variable);

/// How terms take another range.
enum class TermsInRange {
    Stay,   ///< where they are; shoulders go with the ends, and what reaches beyond them is cut off
    Stretch ///< with it
};

/// The variable over another range.
/// @throws InvalidModel where the range is empty, or a term that stays would lie outside
FuzzyVariable withRange(const FuzzyVariable& variable, double minimum, double maximum, TermsInRange terms);

} // namespace esm
