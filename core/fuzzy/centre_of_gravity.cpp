#include "core/fuzzy/centre_of_gravity.h"

#include "core/fuzzy/quadrature.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

struct Interval {
    double left, right;
};

/// The interval lies within the set, and none of the set's bends within the interval.
SetPiece pieceOver(const ImpliedSet& set, const Interval& interval) {
    const auto [left, right] = interval;
    if (right <= set.rise) return {(left - set.start) / set.riseWidth, (right - set.start) / set.riseWidth};
    if (left >= set.fall) return {(set.end - left) / set.fallWidth, (set.end - right) / set.fallWidth};
    return {set.height, set.height};
}

/// Area and first moment about an origin, gathered piece by piece.
struct Gravity {
    double origin;
    double area = 0, moment = 0;

    void add(const Interval& interval, const SetPiece& piece) {
        const double width = interval.right - interval.left;
        const double pieceArea = 0.5 * width * (piece.left + piece.right);
        area += pieceArea;
        moment += pieceArea * (interval.left - origin) + width * width * (piece.left + 2 * piece.right) / 6;
    }

    void addSample(double x, double sampleArea) {
        area += sampleArea;
        moment += sampleArea * (x - origin);
    }
};

/// Adds the upper envelope of the pieces over an interval: follow the highest piece from the left and change
/// to the steeper one that crosses it first.
void addMaximum(Gravity& gravity, const std::vector<SetPiece>& pieces, const Interval& interval) {
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
        gravity.add({x, crossingX}, {degree, crossingDegree});
        x = crossingX;
        degree = crossingDegree;
        highest = next;
    }
    gravity.add({x, interval.right}, {degree, highest->right});
}

/// The sum of the pieces, straight until it reaches 1.
void addBoundedSum(Gravity& gravity, const std::vector<SetPiece>& pieces, const Interval& interval) {
    SetPiece sum{0, 0};
    for (const SetPiece& piece : pieces)
        sum = {sum.left + piece.left, sum.right + piece.right};
    const SetPiece bounded{std::min(sum.left, 1.0), std::min(sum.right, 1.0)};
    const bool bends = (sum.left < 1 && sum.right > 1) || (sum.left > 1 && sum.right < 1);
    if (!bends) {
        gravity.add(interval, bounded);
        return;
    }
    const double part = (1 - sum.left) / (sum.right - sum.left);
    const double bend = interval.left + part * (interval.right - interval.left);
    gravity.add({interval.left, bend}, {bounded.left, 1});
    gravity.add({bend, interval.right}, {1, bounded.right});
}

/// The probabilistic sum of pieces over an interval: a polynomial of as high a degree as pieces are sloped.
struct ProbabilisticSum {
    const SetPiece *sloped, *end;
    double level; ///< the sum of those that are not

    /// `part`: 0 at the interval's left end, 1 at its right.
    double at(double part) const {
        double sum = level;
        for (const SetPiece* piece = sloped; piece != end; ++piece)
            sum = combined(TConorm::ProbabilisticSum, sum, piece->left + part * (piece->right - piece->left));
        return sum;
    }
};

void addByQuadrature(Gravity& gravity, const ProbabilisticSum& sum, const GaussRule& rule,
                     const Interval& interval, const Interval& part) {
    const double middle = 0.5 * (part.left + part.right), half = 0.5 * (part.right - part.left);
    const double width = interval.right - interval.left;
    for (const GaussPair& pair : rule)
        for (const double place : {middle - half * pair.place, middle + half * pair.place})
            gravity.addSample(interval.left + place * width, sum.at(place) * pair.weight * half * width);
}

/// In how many parts quadrature is as exact as doubles are. A polynomial of too high a degree for one part:
/// its n-th derivative is at most Vⁿ, with V the sum of what the pieces rise or fall over the interval, and
/// the error of 16 points over a width w at most (w·V)³² · 16!⁴ / (33 · 32!³), below 10⁻¹⁶ for w·V ≤ 16.
std::size_t partsFor(const ProbabilisticSum& sum) {
    const auto slopes = static_cast<std::size_t>(sum.end - sum.sloped);
    if (slopes < highestGaussDegree) return 1;
    double variation = 0;
    for (const SetPiece* piece = sum.sloped; piece != sum.end; ++piece)
        variation += std::abs(piece->right - piece->left);
    return 1 + static_cast<std::size_t>(variation / 16);
}

void addProbabilisticSum(Gravity& gravity, std::vector<SetPiece>& pieces, const Interval& interval) {
    const auto isLevel = [](const SetPiece& piece) { return piece.left == piece.right; };
    const auto sloped = std::partition(pieces.begin(), pieces.end(), isLevel);
    const auto slopes = static_cast<std::size_t>(pieces.end() - sloped);
    ProbabilisticSum sum{pieces.data() + pieces.size() - slopes, pieces.data() + pieces.size(), 0};
    for (auto piece = pieces.begin(); piece != sloped; ++piece)
        sum.level = combined(TConorm::ProbabilisticSum, sum.level, piece->left);
    if (slopes <= 1) {
        gravity.add(interval, {sum.at(0), sum.at(1)});
        return;
    }
    const GaussRule rule = gaussRuleFor(slopes + 1); // one more for the moment
    const std::size_t parts = partsFor(sum);
    const auto count = static_cast<double>(parts);
    for (std::size_t i = 0; i < parts; ++i)
        addByQuadrature(gravity, sum, rule, interval,
                        {static_cast<double>(i) / count, static_cast<double>(i + 1) / count});
}

void addPieces(Gravity& gravity, std::vector<SetPiece>& pieces, const Interval& interval,
               TConorm aggregation) {
    if (pieces.size() == 1)
        gravity.add(interval, pieces[0]);
    else if (aggregation == TConorm::ProbabilisticSum)
        addProbabilisticSum(gravity, pieces, interval);
    else if (aggregation == TConorm::BoundedSum)
        addBoundedSum(gravity, pieces, interval);
    else
        addMaximum(gravity, pieces, interval);
}

void sortNearlySorted(std::vector<double>& values) {
    constexpr std::size_t few = 64; // beyond them, sets that come in no order would take too long
    if (values.size() > few) {
        std::sort(values.begin(), values.end());
        return;
    }
    for (std::size_t i = 1; i < values.size(); ++i)
        for (std::size_t j = i; j > 0 && values[j] < values[j - 1]; --j)
            std::swap(values[j], values[j - 1]);
}

/// Where every set is a single point there is no area: the points' mean, weighted by their degrees, which is
/// what the centre of gravity tends to as equally wide sets shrink.
double centreOfPoints(std::vector<ImpliedSet>& sets, TConorm aggregation) {
    const auto placeOf = [](const ImpliedSet& set) { return 0.5 * set.start + 0.5 * set.end; };
    std::sort(sets.begin(), sets.end(),
              [&](const ImpliedSet& p, const ImpliedSet& q) { return placeOf(p) < placeOf(q); });
    double weight = 0, moment = 0;
    for (auto set = sets.begin(); set != sets.end();) {
        const double place = placeOf(*set);
        double degree = 0;
        for (; set != sets.end() && placeOf(*set) == place; ++set)
            degree = combined(aggregation, degree, set->height);
        weight += degree;
        moment += degree * place;
    }
    return moment / weight;
}

} // namespace

std::optional<double> centreOfGravity(const FuzzyVariable& variable, TConorm aggregation, OutputSets& work) {
    if (work.sets.empty()) return std::nullopt;
    work.breaks.clear();
    for (const ImpliedSet& set : work.sets)
        for (const double x : {set.start, set.rise, set.fall, set.end})
            work.breaks.push_back(std::clamp(x, variable.minimum, variable.maximum));
    sortNearlySorted(work.breaks);

    Gravity gravity{work.breaks.front()};
    for (std::size_t i = 1; i < work.breaks.size(); ++i) {
        const Interval interval{work.breaks[i - 1], work.breaks[i]};
        if (!(interval.left < interval.right)) continue;
        work.pieces.clear();
        for (const ImpliedSet& set : work.sets)
            if (set.start <= interval.left && set.end >= interval.right)
                work.pieces.push_back(pieceOver(set, interval));
        if (!work.pieces.empty()) addPieces(gravity, work.pieces, interval, aggregation);
    }
    const double centre = gravity.area > 0 ? gravity.origin + gravity.moment / gravity.area
                                           : centreOfPoints(work.sets, aggregation);
    return std::clamp(centre, work.breaks.front(), work.breaks.back());
}

} // namespace esm
