#pragma once

#include "core/support/fields.h"
#include "core/texture/image.h"

#include <string>
#include <vector>

namespace esm {

/// Levels, contrast, saturation and hue of a photo as people like them; by default all stays as it is.
struct ColourAdjustment {
    double blackPoint = 0;   ///< sRGB value that becomes black, below the white point by 1 at least
    double whitePoint = 255; ///< sRGB value that becomes white
    double gamma = 1;        ///< of what lies between them; above 1 it becomes brighter
    double contrast = 1;     ///< factor of what differs from middle grey
    double saturation = 1;   ///< factor of CIE L*a*b* chroma; 0 leaves grey
    double hue = 0;          ///< degrees, by which CIE L*a*b* hue turns, from red towards yellow

    bool operator==(const ColourAdjustment&) const = default;
};
template<>
inline constexpr auto fieldsOf<ColourAdjustment> = fieldTable(
    field("blackPoint", &ColourAdjustment::blackPoint, Limits<double>{"the black point", 0, 254}).whenSet(),
    field("whitePoint", &ColourAdjustment::whitePoint, Limits<double>{"the white point", 1, 255}).whenSet(),
    field("gamma", &ColourAdjustment::gamma, Limits<double>{"the gamma", 0.1, 10}).whenSet(),
    field("contrast", &ColourAdjustment::contrast, Limits<double>{"the contrast", 0, 2}).whenSet(),
    field("saturation", &ColourAdjustment::saturation, Limits<double>{"the saturation", 0, 2}).whenSet(),
    field("hue", &ColourAdjustment::hue, Limits<double>{"the turn of hue", -180, 180, "degrees"}).whenSet());

/// Every problem of an adjustment. Empty when all is well.
std::vector<std::string> validate(const ColourAdjustment& adjustment);

/// First levels, then contrast, of red, green and blue alike in sRGB values; then saturation and hue in CIE
/// L*a*b* (D65), which keeps the lightness. What is transparent stays as it is. Precondition: it validates.
void adjustColours(Image& photo, const ColourAdjustment& adjustment);

} // namespace esm
