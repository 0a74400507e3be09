#include "core/fuzzy/centre_of_gravity.h"

#include "core/fuzzy/aggregated_pieces.h"
#include "core/fuzzy/quadrature.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Area and first moment about an origin, gathered piece by piece. The origin is the left end of what counts
/// and not 0: of sets far from 0 the moment would be a large number of which the place is the last digits.
struct Gravity {
    double origin;
    double area = 0, moment = 0;

    /// A trapezoid of width w with the heights l and r has the area w (l + r) / 2, and the moment w² (l + 2
    /// r) / 6 about its left end.
    void add(const SetInterval& interval, const SetPiece& piece) {
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

/// Gauss and Legendre's places are all inside, symmetric about the middle, and their weights positive: sums
/// of areas lose no digits by cancelling.
void addByQuadrature(Gravity& gravity, const ProbabilisticSum& sum, const GaussRule& rule,
                     const SetInterval& interval, const SetInterval& part) {
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
    if (sum.slopes() < highestGaussDegree) return 1;
    double variation = 0;
    for (const SetPiece* piece = sum.sloped; piece != sum.end; ++piece)
        variation += std::abs(piece->right - piece->left);
    return 1 + static_cast<std::size_t>(variation / 16);
}

/// The sum is a polynomial of as high a degree as pieces are sloped. Expanding it would cost a coefficient
/// for each degree and lose digits where terms of either sign cancel; Gauss and Legendre's quadrature
/// integrates it exactly from values alone.
void addProbabilisticSum(Gravity& gravity, std::vector<SetPiece>& pieces, const SetInterval& interval) {
    const ProbabilisticSum sum = probabilisticSum(pieces);
    if (sum.slopes() <= 1) {
        gravity.add(interval, {sum.at(0), sum.at(1)});
        return;
    }
    const GaussRule rule = gaussRuleFor(sum.slopes() + 1); // one more for the moment
    const std::size_t parts = partsFor(sum);
    const auto count = static_cast<double>(parts);
    for (std::size_t i = 0; i < parts; ++i)
        addByQuadrature(gravity, sum, rule, interval,
                        {static_cast<double>(i) / count, static_cast<double>(i + 1) / count});
}

void addPieces(Gravity& gravity, std::vector<SetPiece>& pieces, const SetInterval& interval,
               TConorm aggregation) {
    const auto gather = [&](const SetInterval& part, const SetPiece& piece) { gravity.add(part, piece); };
    if (pieces.size() == 1)
        gravity.add(interval, pieces[0]);
    else if (aggregation == TConorm::ProbabilisticSum)
        addProbabilisticSum(gravity, pieces, interval);
    else if (aggregation == TConorm::BoundedSum)
        gatherBoundedSum(pieces, interval, gather);
    else
        gatherMaximum(pieces, interval, gather);
}

/// Terms mostly come from left to right, so that the breaks are nearly sorted: insertion then takes little
/// more than one pass.
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
    double weight = 0, moment = 0;
    visitPoints(sets, aggregation, [&](double place, double degree) {
        weight += degree;
        moment += degree * place;
    });
    return moment / weight;
}

} // namespace

void findBreaks(const FuzzyVariable& variable, OutputSets& work) {
    work.breaks.clear();
    for (const ImpliedSet& set : work.sets)
        for (const double x : {set.start, set.rise, set.fall, set.end})
            work.breaks.push_back(std::clamp(x, variable.minimum, variable.maximum));
    sortNearlySorted(work.breaks);
}

/// Level pieces are joined into one number once; only sloped ones are asked at every place of the quadrature.
/// The order does not matter, as the sum is commutative and associative.
ProbabilisticSum probabilisticSum(std::vector<SetPiece>& pieces) {
    const auto isLevel = [](const SetPiece& piece) { return piece.left == piece.right; };
    const auto sloped = std::partition(pieces.begin(), pieces.end(), isLevel);
    const auto slopes = static_cast<std::size_t>(pieces.end() - sloped);
    ProbabilisticSum sum{pieces.data() + pieces.size() - slopes, pieces.data() + pieces.size(), 0};
    for (auto piece = pieces.begin(); piece != sloped; ++piece)
        sum.level = combined(TConorm::ProbabilisticSum, sum.level, piece->left);
    return sum;
}

/// The exact centre of gravity [R 2.3.6]: ∫ x·μ(x) dx / ∫ μ(x) dx over the aggregated set, in closed form
/// between the places where some set bends. The usual way samples μ at some hundred places; it costs more, is
/// only as exact as its steps, and misses a set that is narrower than one. The result is held within what the
/// sets reach, which rounding could leave by a last digit.
std::optional<double> centreOfGravity(const FuzzyVariable& variable, TConorm aggregation, OutputSets& work) {
    if (work.sets.empty()) return std::nullopt;
    findBreaks(variable, work);
    Gravity gravity{work.breaks.front()};
    visitPieces(work,
                [&](const SetInterval& interval) { addPieces(gravity, work.pieces, interval, aggregation); });
    const double centre = gravity.area > 0 ? gravity.origin + gravity.moment / gravity.area
                                           : centreOfPoints(work.sets, aggregation);
    return std::clamp(centre, work.breaks.front(), work.breaks.back());
}

} // namespace esm
