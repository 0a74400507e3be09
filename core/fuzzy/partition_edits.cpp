#include "core/fuzzy/partition_edits.h"

#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace esm {

namespace {

constexpr std::array<double Trapezoid::*, 4> cornerMembers{&Trapezoid::a, &Trapezoid::b, &Trapezoid::c,
                                                           &Trapezoid::d};

/// Between two bounds, the lower of which counts where they are crossed.
double between(double lower, double upper, double value) {
    return std::max(lower, std::min(upper, value));
}

/// A term whose upright side is at the end of the range stands for all values beyond as well: whatever is
/// done to the range or the term, that side stays at the end.
bool isLeftShoulder(const FuzzyVariable& variable, const Trapezoid& set) {
    return set.a == set.b && set.a == variable.minimum && !isSinglePoint(set);
}

bool isRightShoulder(const FuzzyVariable& variable, const Trapezoid& set) {
    return set.c == set.d && set.d == variable.maximum && !isSinglePoint(set);
}

double middle(const Trapezoid& set) {
    return set.b + (set.c - set.b) / 2;
}

/// The share of the flat parts that a flank takes of either side where two of them touch.
constexpr double flankShare = 0.25;

/// Draws the flank between two neighbours, the first of which has the lower middle: from the end of one core
/// to the beginning of the next. Both terms get the same two corners, one falling, one rising: their degrees
/// then add up to 1 at every place of it (Ruspini's partition, 1969). Where cores overlap the flank lies over
/// their overlap; where they touch there is none, and a quarter of either half core is taken for it. It never
/// goes beyond a middle, so that no term loses its core.
void shareFlank(Trapezoid& lower, Trapezoid& upper, double lowerMiddle, double upperMiddle) {
    double from = std::clamp(std::min(lower.c, upper.b), lowerMiddle, upperMiddle);
    double to = std::clamp(std::max(lower.c, upper.b), lowerMiddle, upperMiddle);
    if (!(from < to)) {
        const double border = from;
        from = border - flankShare * (border - lowerMiddle);
        to = border + flankShare * (upperMiddle - border);
    }
    lower.c = upper.a = from;
    lower.d = upper.b = to;
}

/// Rounding may turn two corners around that were equal or nearly so: each is held at least at the one before
/// it.
Trapezoid stretched(const FuzzyVariable& variable, const Trapezoid& set, double minimum, double maximum) {
    const auto moved = [&](double corner) {
        // The ends are met exactly: shoulders stay shoulders.
        if (corner == variable.maximum) return maximum;
        const double share = (corner - variable.minimum) / (variable.maximum - variable.minimum);
        return minimum + share * (maximum - minimum);
    };
    Trapezoid result;
    double least = -std::numeric_limits<double>::infinity();
    for (const auto corner : cornerMembers)
        least = result.*corner = std::max(least, moved(set.*corner));
    return result;
}

Trapezoid staying(const FuzzyVariable& variable, const FuzzyTerm& term, double minimum, double maximum) {
    Trapezoid set = term.set;
    if (isSinglePoint(set) ? set.a < minimum || set.a > maximum : set.d <= minimum || set.a >= maximum)
        throw InvalidModel("\"" + term.name + "\" would lie outside " + roundedText(minimum) + " to " +
                           roundedText(maximum) + ": move or remove it first, or let the terms stretch");
    if (isLeftShoulder(variable, set)) set.a = set.b = minimum;
    if (isRightShoulder(variable, set)) set.c = set.d = maximum;
    for (const auto corner : cornerMembers)
        set.*corner = std::clamp(set.*corner, minimum, maximum);
    return set;
}

} // namespace

double cornerOf(const Trapezoid& set, Corner corner) {
    return set.*cornerMembers[static_cast<std::size_t>(corner)];
}

/// A corner goes as far as its neighbours and the ends of the range. One that lies outside already, as a file
/// may have it, may stay or come nearer: it must not jump because it was touched.
Trapezoid withCorner(const FuzzyVariable& variable, std::size_t term, Corner corner, double value) {
    Trapezoid set = variable.terms[term].set;
    const auto place = static_cast<std::size_t>(corner);
    // What lies beyond the range already may stay there.
    double& moved = set.*cornerMembers[place];
    moved = between(std::min(variable.minimum, moved), std::max(variable.maximum, moved), value);
    if (place < 3) moved = std::min(moved, set.*cornerMembers[place + 1]);
    if (place > 0) moved = std::max(moved, set.*cornerMembers[place - 1]);
    return set;
}

/// A shoulder's upright side stays with the end of the range, so that the term becomes wider or narrower. One
/// that is a shoulder at both ends fills the range and has nowhere to go.
Trapezoid shifted(const FuzzyVariable& variable, std::size_t term, double by) {
    Trapezoid set = variable.terms[term].set;
    const bool staysLeft = isLeftShoulder(variable, set), staysRight = isRightShoulder(variable, set);
    if (staysLeft && staysRight) return set;
    const double lowest = staysLeft ? set.c : set.a, highest = staysRight ? set.b : set.d;
    const double shift =
        between(std::min(0.0, variable.minimum - lowest), std::max(0.0, variable.maximum - highest), by);
    for (const auto corner : cornerMembers) {
        const bool isLeft = corner == &Trapezoid::a || corner == &Trapezoid::b;
        if (!(isLeft ? staysLeft : staysRight)) set.*corner += shift;
    }
    return set;
}

/// Other corners and the ends come before round numbers, as partitions are mostly drawn corner to corner; the
/// nearest within reach is taken.
double snapped(const FuzzyVariable& variable, std::size_t term, double value, const Snapping& snapping) {
    double nearest = variable.minimum;
    const auto consider = [&](double candidate) {
        if (std::abs(candidate - value) < std::abs(nearest - value)) nearest = candidate;
    };
    consider(variable.maximum);
    for (std::size_t i = 0; i < variable.terms.size(); ++i)
        if (i != term)
            for (const auto corner : cornerMembers)
                consider(variable.terms[i].set.*corner);
    if (std::abs(nearest - value) <= snapping.reach) return nearest;
    if (!(snapping.step > 0)) return value;
    // Divided by a whole number, 0.3 comes out as it is written, which three times 0.1 does not.
    return snapping.step < 1 ? std::round(value / snapping.step) / std::round(1 / snapping.step)
                             : std::round(value / snapping.step) * snapping.step;
}

/// The next of 1, 2, 5 times a power of ten: steps that people count in.
double roundStep(double least) {
    const double power = std::pow(10, std::floor(std::log10(least)));
    for (const double factor : {1, 2, 5})
        // A hair below is rounding.
        if (factor * power >= least * (1 - 1e-9)) return factor * power;
    return 10 * power;
}

/// n cores and n − 1 flanks between them, all of one width: 2n − 1 pieces. Term i has its core over piece 2i
/// and a flank on either side; the first and the last go to the ends, as shoulders.
std::vector<FuzzyTerm> evenPartition(const FuzzyVariable& variable) {
    std::vector<FuzzyTerm> terms = variable.terms;
    const double pieces = 2 * static_cast<double>(terms.size()) - 1;
    const auto at = [&](double piece) {
        return piece <= 0        ? variable.minimum
               : piece >= pieces ? variable.maximum
                                 : variable.minimum + (variable.maximum - variable.minimum) * piece / pieces;
    };
    for (std::size_t i = 0; i < terms.size(); ++i) {
        const double core = 2 * static_cast<double>(i);
        terms[i].set = {at(core - 1), at(core), at(core + 1), at(core + 2)};
    }
    return terms;
}

/// Neighbours are those whose middles follow each other: a list may have any order. Each pair shares one
/// flank, so that one pass over the pairs lays all of them.
std::vector<FuzzyTerm> overlappedByHalf(const FuzzyVariable& variable) {
    std::vector<FuzzyTerm> terms = variable.terms;
    std::vector<double> middles;
    for (FuzzyTerm& term : terms) {
        for (const auto corner : cornerMembers)
            term.set.*corner = std::clamp(term.set.*corner, variable.minimum, variable.maximum);
        middles.push_back(middle(term.set));
    }
    std::vector<std::size_t> rising(terms.size());
    std::iota(rising.begin(), rising.end(), std::size_t{0});
    std::stable_sort(rising.begin(), rising.end(),
                     [&](std::size_t one, std::size_t other) { return middles[one] < middles[other]; });
    for (std::size_t i = 1; i < rising.size(); ++i) {
        const std::size_t lower = rising[i - 1], upper = rising[i];
        if (!(middles[lower] < middles[upper]))
            throw InvalidModel("\"" + terms[lower].name + "\" and \"" + terms[upper].name +
                               "\" have their middle at the same place: move one of them first");
        shareFlank(terms[lower].set, terms[upper].set, middles[lower], middles[upper]);
    }
    terms[rising.front()].set.a = terms[rising.front()].set.b = variable.minimum;
    terms[rising.back()].set.c = terms[rising.back()].set.d = variable.maximum;
    return terms;
}

FuzzyVariable withRange(const FuzzyVariable& variable, double minimum, double maximum, TermsInRange terms) {
    if (!(minimum < maximum))
        throw InvalidModel("the range must rise, got " + roundedText(minimum) + " to " +
                           roundedText(maximum));
    FuzzyVariable result = variable;
    result.minimum = minimum;
    result.maximum = maximum;
    for (FuzzyTerm& term : result.terms)
        term.set = terms == TermsInRange::Stretch ? stretched(variable, term.set, minimum, maximum)
                                                  : staying(variable, term, minimum, maximum);
    return result;
}

} // namespace esm
