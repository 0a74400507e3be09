#pragma once

#include "core/fuzzy/centre_of_gravity.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace esm {

/// Part of an output's range over which no set bends.
struct SetInterval {
    double left, right;
};

/// The interval lies within the set, and none of the set's bends within the interval.
inline SetPiece pieceOver(const ImpliedSet& set, const SetInterval& interval) {
    const auto [left, right] = interval;
    if (right <= set.rise) return {(left - set.start) / set.riseWidth, (right - set.start) / set.riseWidth};
    if (left >= set.fall) return {(set.end - left) / set.fallWidth, (set.end - right) / set.fallWidth};
    return {set.height, set.height};
}

/// Where the sets bend, within the variable's range, in rising order.
void findBreaks(const FuzzyVariable& variable, OutputSets& work);

/// Calls `visit(interval)` from left to right with `work.pieces` of the sets over it, for every interval that
/// is in some of them. Precondition: findBreaks(). Between two neighbouring breaks no set bends, starts or
/// ends, so that each is one straight piece there or nothing.
template<class Visit> void visitPieces(OutputSets& work, const Visit& visit) {
    for (std::size_t i = 1; i < work.breaks.size(); ++i) {
        const SetInterval interval{work.breaks[i - 1], work.breaks[i]};
        if (!(interval.left < interval.right)) continue;
        work.pieces.clear();
        for (const ImpliedSet& set : work.sets)
            if (set.start <= interval.left && set.end >= interval.right)
                work.pieces.push_back(pieceOver(set, interval));
        if (!work.pieces.empty()) visit(interval);
    }
}

/// Hands the upper envelope of the pieces over an interval to `gather(interval, piece)`, straight part by
/// straight part: follow the highest piece from the left and change to the steeper one that crosses it first.
template<class Gather>
void gatherMaximum(const std::vector<SetPiece>& pieces, const SetInterval& interval, const Gather& gather) {
    const auto isLower = [](const SetPiece& p, const SetPiece& q) {
        return p.left < q.left || (p.left == q.left && p.right < q.right);
    };
    const SetPiece* highest = &*std::max_element(pieces.begin(), pieces.end(), isLower);
    double x = interval.left, degree = highest->left;
    for (;;) {
        const SetPiece* next = nullptr;
        double firstCrossing = 1; // as a part of the interval
        for (const SetPiece& piece : pieces) {
            const double rising = (piece.right - piece.left) - (highest->right - highest->left);
            if (piece.right <= highest->right || rising <= 0) continue;
            const double crossing = (highest->left - piece.left) / rising;
            if (crossing > firstCrossing || (crossing == firstCrossing && next && piece.right <= next->right))
                continue;
            firstCrossing = crossing;
            next = &piece;
        }
        if (!next) break;
        const double crossingX = interval.left + firstCrossing * (interval.right - interval.left);
        const double crossingDegree = highest->left + firstCrossing * (highest->right - highest->left);
        gather(SetInterval{x, crossingX}, SetPiece{degree, crossingDegree});
        x = crossingX;
        degree = crossingDegree;
        highest = next;
    }
    gather(SetInterval{x, interval.right}, SetPiece{degree, highest->right});
}

/// The same of the sum of the pieces, which is straight until it reaches 1.
template<class Gather>
void gatherBoundedSum(const std::vector<SetPiece>& pieces, const SetInterval& interval,
                      const Gather& gather) {
    SetPiece sum{0, 0};
    for (const SetPiece& piece : pieces)
        sum = {sum.left + piece.left, sum.right + piece.right};
    const SetPiece bounded{std::min(sum.left, 1.0), std::min(sum.right, 1.0)};
    const bool bends = (sum.left < 1 && sum.right > 1) || (sum.left > 1 && sum.right < 1);
    if (!bends) {
        gather(interval, bounded);
        return;
    }
    const double part = (1 - sum.left) / (sum.right - sum.left);
    const double bend = interval.left + part * (interval.right - interval.left);
    gather(SetInterval{interval.left, bend}, SetPiece{bounded.left, 1});
    gather(SetInterval{bend, interval.right}, SetPiece{1, bounded.right});
}

/// The probabilistic sum of pieces over an interval: a polynomial of as high a degree as pieces are sloped.
struct ProbabilisticSum {
    const SetPiece *sloped, *end;
    double level; ///< the sum of those that are not

    std::size_t slopes() const { return static_cast<std::size_t>(end - sloped); }
    /// `part`: 0 at the interval's left end, 1 at its right. Combined one by one, as 1 − Π (1 − pᵢ) would
    /// lose the digits of small degrees.
    double at(double part) const {
        double sum = level;
        for (const SetPiece* piece = sloped; piece != end; ++piece)
            sum = combined(TConorm::ProbabilisticSum, sum, piece->left + part * (piece->right - piece->left));
        return sum;
    }
};

/// Puts the pieces into another order, and lives no longer than they do.
ProbabilisticSum probabilisticSum(std::vector<SetPiece>& pieces);

/// Sorts sets by the place of each, which is a single point, and calls `visit(place, degree)` for every place
/// from left to right.
template<class Visit>
void visitPoints(std::vector<ImpliedSet>& sets, TConorm aggregation, const Visit& visit) {
    const auto placeOf = [](const ImpliedSet& set) { return 0.5 * set.start + 0.5 * set.end; };
    std::sort(sets.begin(), sets.end(),
              [&](const ImpliedSet& p, const ImpliedSet& q) { return placeOf(p) < placeOf(q); });
    for (auto set = sets.begin(); set != sets.end();) {
        const double place = placeOf(*set);
        double degree = 0;
        for (; set != sets.end() && placeOf(*set) == place; ++set)
            degree = combined(aggregation, degree, set->height);
        visit(place, degree);
    }
}

} // namespace esm
