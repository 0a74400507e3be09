#pragma once

#include "core/support/fields.h"
#include "core/texture/image.h"

#include <array>
#include <optional>

namespace esm {

/// What the lightness and the two colour axes of CIE L*a*b* (D65) are multiplied with, and what is added
/// then.
struct ColourMatch {
    std::array<double, 3> scale{1, 1, 1};
    std::array<double, 3> offset{0, 0, 0};

    bool operator==(const ColourMatch&) const = default;
};

constexpr double smallestSpread = 0.5, largestSpread = 2; ///< of a match's scales

template<>
inline constexpr auto fieldsOf<ColourMatch> = fieldTable(
    field("scale", &ColourMatch::scale,
          Limits<double>{"the scales of matched colours", smallestSpread, largestSpread}),
    field("offset", &ColourMatch::offset, Limits<double>{"the offsets of matched colours", -300, 300}));

/// Gives the photo the mean colour and the spread of what lies beneath it (Reinhard et al. 2001, Color
/// transfer between images), over the pixels where both have alpha; both must have one size. Spreads change
/// by a factor of 0.5 to 2. Of the photo what is nearly black does not count, as corners around a field that
/// is not masked. Nothing where fewer than 100 pixels count.
std::optional<ColourMatch> matchColours(const Image& photo, const Image& beneath);

/// What is nearly black or transparent stays as it is.
void applyMatch(Image& photo, const ColourMatch& match);

} // namespace esm
