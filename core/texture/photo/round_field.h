#pragma once

#include "core/texture/image.h"

#include <optional>

namespace esm {

/// The round picture that an endoscope leaves in a dark photo, in photo pixels from the top left corner.
struct RoundField {
    double centreX = 0, centreY = 0, radius = 0;
    double trim = 2; ///< percent of the radius that is left away at the rim, 0 to 90

    bool operator==(const RoundField&) const = default;
};

/// The circle at which the dark rim ends, fitted to the border's points so that instruments, dark organs and
/// straight edges of the photo do not draw it aside. Nothing where there is no such border.
std::optional<RoundField> findRoundField(const Image& photo);

/// Takes the alpha outside the field away, over one pixel at its rim.
void maskField(Image& photo, const RoundField& field);

} // namespace esm
