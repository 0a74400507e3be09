#include "core/solid/narrow_crossings.h"

#include "core/solid/crossings.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>

namespace esm {

namespace {

// A thin body has a finer lattice than was asked for, and that one must not see the crossing.
std::vector<Crossing> crossingsAt(const std::vector<ClosedBody>& bodies, double spacing,
                                  const Progress& progress) {
    std::vector<double> spacings;
    spacings.reserve(bodies.size());
    for (const ClosedBody& body : bodies)
        spacings.push_back(spacingWithin(body, spacing));
    return crossingsOf(bodies, spacings, progress);
}

/// Beside its lattice. Precondition: there are some.
const Crossing& widestOf(const std::vector<Crossing>& crossings) {
    return *std::max_element(crossings.begin(), crossings.end(),
                             [](const Crossing& one, const Crossing& other) {
                                 return one.width / one.spacing < other.width / other.spacing;
                             });
}

// Of a wide crossing no more is known than that it is: what is misplaced beyond it is not looked for. So each
// spacing that would do by what is known is tried.
/// The finest to two digits that sees no crossing, m; 0 where the organ is too thin for such a one.
double narrowingSpacing(const std::vector<ClosedBody>& bodies, double spacing, const Crossing& widest,
                        ProgressParts parts) {
    double least = 2 * widest.width;
    while (least > spacing && least <= 2 * thickness(largestOf(bodies))) {
        spacing = toTwoDigitsUp(least);
        const std::vector<Crossing> crossings = crossingsAt(bodies, spacing, parts.nextOfRest(0.5));
        const Crossing& left = widestOf(crossings);
        if (left.isNarrow()) return spacing;
        least = 2 * left.width;
    }
    return 0;
}

std::string wideText(const std::vector<Crossing>& crossings, double spacing, double enough) {
    const Crossing& widest = widestOf(crossings);
    std::size_t pairs = 0;
    for (const Crossing& crossing : crossings)
        pairs += crossing.pairs;
    return "the surface runs through itself: " + std::to_string(pairs) +
           " pairs of triangles meet; the widest place, near " + placeText(widest.place) + ", is " +
           millimetresText(widest.width, 2) + " across, and a lattice of " + millimetresText(spacing, 3) +
           " passes over " + millimetresText(widest.spacing / 2, 2) + " at most; " +
           (enough > 0 ? "choose a spacing of " + millimetresText(enough, 2) + " or more, " : std::string()) +
           partOrJoinThem;
}

} // namespace

// What is looked for first are the places at this spacing; only where one is wide is it asked, spacing by
// spacing, which would do: most surfaces never come to that.
NarrowCrossings narrowCrossingsOf(const std::vector<ClosedBody>& bodies, double spacing,
                                  const Progress& progress) {
    ProgressParts parts(progress);
    const std::vector<Crossing> crossings = crossingsAt(bodies, spacing, parts.next(0.5));
    if (!crossings.empty() && !widestOf(crossings).isNarrow()) {
        const double enough = narrowingSpacing(bodies, spacing, widestOf(crossings), std::move(parts));
        throw InvalidModel(wideText(crossings, spacing, enough));
    }
    reportProgress(progress, 1);
    if (crossings.empty()) return {};
    const auto widest =
        std::max_element(crossings.begin(), crossings.end(),
                         [](const auto& one, const auto& other) { return one.width < other.width; });
    return {crossings.size(), widest->width};
}

} // namespace esm
