#pragma once

#include "core/support/words.h"
#include "core/texture/projection/landmark_pair.h"

#include <array>
#include <vector>

namespace esm {

/// Ways in which landmarks tell a pose badly.
enum class Weakness {
    NearlyOnALine, ///< they leave the turn about the line open
    NearlyPlanar,  ///< they hardly tell near and zoomed apart, and may be seen from either side
    CloseTogether, ///< they fill little of the photo
};

template<>
inline constexpr auto wordsOf<Weakness> = std::array{Word{Weakness::NearlyOnALine, "nearly_on_a_line"},
                                                     Word{Weakness::NearlyPlanar, "nearly_planar"},
                                                     Word{Weakness::CloseTogether, "close_together"}};

/// How the pairs that count are weak; empty where they are well spread.
std::vector<Weakness> weaknessesOf(const std::vector<LandmarkPair>& pairs, const std::vector<bool>& counts,
                                   double photoDiagonal);

/// Whether the points are on a line in the photo, on the organ, for all that a solver can tell.
bool isOnALineInPhoto(const std::vector<LandmarkPair>& pairs);
bool isOnALineOnOrgan(const std::vector<LandmarkPair>& pairs);

} // namespace esm
