#pragma once

#include "core/support/fields.h"
#include "core/support/progress.h"
#include "core/texture/image.h"
#include "core/texture/photo/colour_adjustment.h"
#include "core/texture/photo/colour_match.h"
#include "core/texture/photo/even_light.h"
#include "core/texture/photo/highlights.h"
#include "core/texture/photo/lens.h"
#include "core/texture/photo/photo_colours.h"
#include "core/texture/photo/photo_field.h"
#include "core/texture/photo/photo_mask.h"
#include "core/texture/photo/white_balance.h"
#include "core/texture/texture_limits.h"

#include <optional>
#include <string>
#include <vector>

namespace esm {

/// What stays of a photo, in pixels from its top left corner.
struct PhotoCrop {
    int x = 0, y = 0, width = 0, height = 0;

    bool operator==(const PhotoCrop&) const = default;
};
template<>
inline constexpr auto fieldsOf<PhotoCrop> = [] {
    constexpr int most = texture_limits::mostPhotoPixels;
    return fieldTable(
        field("x", &PhotoCrop::x, Limits<int>{"the crop's x", 0, most, "pixels"}),
        field("y", &PhotoCrop::y, Limits<int>{"the crop's y", 0, most, "pixels"}),
        field("width", &PhotoCrop::width, Limits<int>{"the crop's width", 0, most, "pixels"}),
        field("height", &PhotoCrop::height, Limits<int>{"the crop's height", 0, most, "pixels"}));
}();

/// What is done to a photo before it is laid on the organ; by default nothing. Applied in this order, so that
/// the field and the strokes lie on the photo as it was taken and the crop on what comes out.
struct PhotoPreparation {
    std::optional<PhotoField> field;       ///< alpha 0 outside
    std::vector<PhotoStroke> strokes;      ///< what brush and outlines leave out and take back, in order
    std::optional<int> highlightThreshold; ///< as projects before version 10 say it, see highlightsAbove()
    std::optional<double>
        highlightSensitivity; ///< 0 to 1: what shines as much is filled; in place of the threshold
    double evenLight = 0;     ///< 0 to 1
    std::optional<ColourGains> whiteBalance;
    std::optional<ColourMatch> match; ///< to what lies beneath
    std::optional<Lens> lens;
    std::optional<PhotoCrop> crop; ///< alpha 0 outside
    ColourAdjustment adjustment;   ///< as people like it; of what all before leaves

    bool isNothing() const;
    /// Whether parts of the photo may become transparent.
    bool leavesOut() const { return field || !strokes.empty() || lens || crop; }
    bool fillsHighlights() const { return highlightThreshold || highlightSensitivity; }

    bool operator==(const PhotoPreparation&) const = default;
};
template<>
inline constexpr auto fieldsOf<PhotoPreparation> = fieldTable(
    // A circle stands where older programs look for it, and every other field beside it.
    field("roundField", &PhotoPreparation::field)
        .whenSet()
        .onlyWhere([](const PhotoPreparation& preparation) {
            return !preparation.field || preparation.field->isCircle();
        }),
    field("field", &PhotoPreparation::field).whenSet().onlyWhere([](const PhotoPreparation& preparation) {
        return !preparation.field || !preparation.field->isCircle();
    }),
    field("strokes", &PhotoPreparation::strokes).whenSet(),
    field("highlights", &PhotoPreparation::highlightThreshold,
          Limits<int>{"the threshold of highlights", 1, 255})
        .whenSet(),
    field("highlightSensitivity", &PhotoPreparation::highlightSensitivity,
          Limits<double>{"the sensitivity to highlights", 0, 1})
        .whenSet(),
    field("evenLight", &PhotoPreparation::evenLight, Limits<double>{"the strength of even light", 0, 1})
        .whenSet(),
    field("whiteBalance", &PhotoPreparation::whiteBalance,
          Limits<double>{"the gains of white balance", smallestGain, largestGain})
        .whenSet(),
    field("colourMatch", &PhotoPreparation::match).whenSet(),
    field("lens", &PhotoPreparation::lens).whenSet(), field("crop", &PhotoPreparation::crop).whenSet(),
    field("adjustment", &PhotoPreparation::adjustment).whenSet());

/// Every problem of a preparation for a photo of that size. Empty when all is well.
std::vector<std::string> validate(const PhotoPreparation& preparation, int width, int height);

/// Steps whose numbers are to be found in the photo itself.
struct StepsToFind {
    bool field = false, whiteBalance = false, overlays = false;
    bool any() const { return field || whiteBalance || overlays; }
};

/// The preparation with those steps as the photo shows them, absent where nothing is found. Each looks only
/// at what those before it leave: field, overlays, white balance. Outlines of overlays come before its
/// strokes.
PhotoPreparation withFound(PhotoPreparation preparation, const Image& photo, StepsToFind steps);

/// The photo without what field and strokes leave out: what later steps look at.
Image shownOf(const Image& photo, const PhotoPreparation& preparation);

/// Where highlights are filled, of what field and strokes leave. Empty without that step.
PixelMask highlightsOf(const Image& photo, const PhotoPreparation& preparation);

/// What a preparation does that can hardly be meant, for people: a field that leaves nothing or all of the
/// photo, strokes that leave none of it.
std::vector<std::string> warningsOf(const Image& photo, const PhotoPreparation& preparation);

/// The share of what field and strokes leave that counts for highlights and is filled, 0 to 1; 0 without that
/// step.
double highlightShare(const Image& photo, const PhotoPreparation& preparation);

/// The photo as the preparation makes it, of the same size. Pure, and the same with any number of threads.
/// @throws InvalidModel with what validate() finds, Cancelled between two steps
Image prepared(const Image& photo, const PhotoPreparation& preparation, const Progress& progress = {});

} // namespace esm
