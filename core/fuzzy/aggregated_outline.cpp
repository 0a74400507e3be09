#include "core/fuzzy/aggregated_outline.h"

#include "core/fuzzy/aggregated_pieces.h"

#include <cmath>

namespace esm {

namespace {

/// A chord no longer than a 400th of the range: finer than a pixel in a drawing of usual width.
constexpr double samplesOverRange = 400;

/// Joins straight parts that come from left to right; where none is, the degree is 0.
class OutlineBuilder {
public:
    explicit OutlineBuilder(double from) { m_outline.push_back({from, 0}); }

    void add(const SetInterval& interval, const SetPiece& piece) {
        if (interval.left > m_outline.back().x) goTo({m_outline.back().x, 0});
        if (interval.left > m_outline.back().x) goTo({interval.left, 0});
        goTo({interval.left, piece.left});
        goTo({interval.right, piece.right});
    }

    Outline finish(double to) {
        goTo({m_outline.back().x, 0});
        goTo({to, 0});
        return std::move(m_outline);
    }

private:
    void goTo(const OutlinePoint& point) {
        const OutlinePoint& last = m_outline.back();
        if (point.x != last.x || point.degree != last.degree) m_outline.push_back(point);
    }

    Outline m_outline;
};

/// Each end is computed once and used by both parts beside it, so that no jump shows; the last is the
/// interval's end itself, which share · width would miss by rounding.
void sampleProbabilisticSum(OutlineBuilder& builder, std::vector<SetPiece>& pieces,
                            const SetInterval& interval, double longest) {
    const ProbabilisticSum sum = probabilisticSum(pieces);
    const double width = interval.right - interval.left;
    const double parts = sum.slopes() <= 1 ? 1 : std::ceil(width / longest);
    const auto count = static_cast<std::size_t>(parts);
    SetInterval part{interval.left, 0};
    SetPiece piece{sum.at(0), 0};
    for (std::size_t i = 1; i <= count; ++i) {
        const double share = static_cast<double>(i) / parts;
        part.right = i == count ? interval.right : interval.left + share * width;
        piece.right = sum.at(share);
        builder.add(part, piece);
        part.left = part.right;
        piece.left = piece.right;
    }
}

} // namespace

/// Corners outside the range are moved to its ends, and parts without width left out: a set cut off by the
/// range stands upright there, as the centre of gravity sees it.
Outline outlineOf(const ImpliedSet& set, const FuzzyVariable& variable) {
    const double low = std::max(set.start, variable.minimum), high = std::min(set.end, variable.maximum);
    Outline outline{{low, 0}};
    const auto add = [&](double x, double degree) {
        if (outline.back().x != x || outline.back().degree != degree) outline.push_back({x, degree});
    };
    if (set.start == set.end)
        add(low, set.height);
    else {
        double x = low;
        for (const double corner : {set.rise, set.fall, high}) {
            const double next = std::clamp(corner, low, high);
            if (!(next > x)) continue;
            const SetInterval interval{x, next};
            const SetPiece piece = pieceOver(set, interval);
            add(x, piece.left);
            add(next, piece.right);
            x = next;
        }
    }
    add(high, 0);
    return outline;
}

/// Drawn from the same pieces that the centre of gravity is computed from, so that what is shown is what was
/// computed. Between two breaks every set is straight; the maximum and the bounded sum of straight pieces are
/// straight in parts, whose corners are found exactly. The probabilistic sum multiplies them: with one sloped
/// piece it is straight still, with more a polynomial, which chords stand for.
Outline aggregatedOutline(const FuzzyVariable& variable, TConorm aggregation, OutputSets& work) {
    OutlineBuilder builder(variable.minimum);
    const auto gather = [&](const SetInterval& part, const SetPiece& piece) { builder.add(part, piece); };
    bool hasArea = false;
    findBreaks(variable, work);
    visitPieces(work, [&](const SetInterval& interval) {
        hasArea = true;
        if (aggregation == TConorm::ProbabilisticSum)
            sampleProbabilisticSum(builder, work.pieces, interval,
                                   (variable.maximum - variable.minimum) / samplesOverRange);
        else if (aggregation == TConorm::BoundedSum)
            gatherBoundedSum(work.pieces, interval, gather);
        else
            gatherMaximum(work.pieces, interval, gather);
    });
    if (!hasArea)
        visitPoints(work.sets, aggregation, [&](double place, double degree) {
            builder.add({place, place}, {degree, degree});
        });
    return builder.finish(variable.maximum);
}

} // namespace esm
