#pragma once

#include "core/support/progress.h"
#include "core/texture/image.h"
#include "core/texture/photo/colour_match.h"
#include "core/texture/photo/even_light.h"
#include "core/texture/photo/highlights.h"
#include "core/texture/photo/lens.h"
#include "core/texture/photo/photo_colours.h"
#include "core/texture/photo/photo_mask.h"
#include "core/texture/photo/round_field.h"

#include <optional>
#include <string>
#include <vector>

namespace esm {

/// What stays of a photo, in pixels from its top left corner.
struct PhotoCrop {
    int x = 0, y = 0, width = 0, height = 0;

    bool operator==(const PhotoCrop&) const = default;
};

/// What is done to a photo before it is laid on the organ; by default nothing. Applied in this order, so that
/// the field and the strokes lie on the photo as it was taken and the crop on what comes out.
struct PhotoPreparation {
    std::optional<RoundField> field;       ///< alpha 0 outside
    std::vector<PhotoStroke> strokes;      ///< what a brush leaves out and takes back, in order
    std::optional<int> highlightThreshold; ///< 1 to 255, of the darkest channel: pixels above it are filled
    double evenLight = 0;                  ///< 0 to 1
    std::optional<ColourGains> whiteBalance;
    std::optional<ColourMatch> match; ///< to what lies beneath
    std::optional<Lens> lens;
    std::optional<PhotoCrop> crop; ///< alpha 0 outside

    bool isNothing() const;

    bool operator==(const PhotoPreparation&) const = default;
};

/// Every problem of a preparation for a photo of that size. Empty when all is well.
std::vector<std::string> validate(const PhotoPreparation& preparation, int width, int height);

/// Steps whose numbers are to be found in the photo itself.
struct StepsToFind {
    bool field = false, whiteBalance = false;
    bool any() const { return field || whiteBalance; }
};

/// The preparation with those steps as the photo shows them, absent where nothing is found.
PhotoPreparation withFound(PhotoPreparation preparation, const Image& photo, StepsToFind steps);

/// The share of what field and strokes leave that counts for highlights and is filled, 0 to 1; 0 without that
/// step.
double highlightShare(const Image& photo, const PhotoPreparation& preparation);

/// The photo as the preparation makes it, of the same size. Pure, and the same with any number of threads.
/// @throws InvalidModel with what validate() finds, Cancelled between two steps
Image prepared(const Image& photo, const PhotoPreparation& preparation, const Progress& progress = {});

} // namespace esm
