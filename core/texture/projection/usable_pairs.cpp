#include "core/texture/projection/usable_pairs.h"

#include "core/support/errors.h"
#include "core/texture/projection/landmark_spread.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Of the photo's diagonal: how far beyond the photo's border a click may lie.
constexpr double beyondBorder = 0.01;

std::string numbersOf(std::size_t first, std::size_t second) {
    return std::to_string(first + 1) + " and " + std::to_string(second + 1);
}

void requireDistinct(const std::vector<LandmarkPair>& pairs) {
    for (std::size_t i = 0; i < pairs.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (pairs[i].photo == pairs[j].photo || pairs[i].organ == pairs[j].organ)
                throw InvalidModel("the pairs " + numbersOf(j, i) +
                                   " share a point; each landmark needs its own");
}

/// A click may miss the border by a little; more, and it is another photo's.
void requireInside(const Eigen::Vector2d& place, std::size_t pair, const PhotoSize& size) {
    const double margin = beyondBorder * std::hypot(size.width, size.height);
    if (place.minCoeff() >= -margin && place.x() <= size.width + margin && place.y() <= size.height + margin)
        return;
    throw InvalidModel("pair " + std::to_string(pair + 1) + " lies outside the photo of " +
                       std::to_string(size.width) + " × " + std::to_string(size.height) +
                       " pixels: it is another photo's, or the photo was scaled");
}

} // namespace

void requireUsable(const std::vector<LandmarkPair>& pairs, const PhotoSize& photo) {
    if (pairs.size() < leastPairs)
        throw InvalidModel("there are " + std::to_string(pairs.size()) + " pairs; a pose takes 4 or more");
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (!pairs[i].photo.allFinite() || !pairs[i].organ.allFinite())
            throw InvalidModel("pair " + std::to_string(i + 1) + " is not finite");
        requireInside(pairs[i].photo, i, photo);
    }
    requireDistinct(pairs);
    if (isOnALineInPhoto(pairs))
        throw InvalidModel("the points in the photo lie on a line; add pairs beside it");
    if (isOnALineOnOrgan(pairs))
        throw InvalidModel("the points on the organ lie on a line; add pairs beside it");
}

ScaledPairs::ScaledPairs(const std::vector<LandmarkPair>& given) : pairs(given) {
    for (const LandmarkPair& pair : pairs)
        middle += pair.organ / static_cast<double>(pairs.size());
    for (const LandmarkPair& pair : pairs)
        size = std::max(size, (pair.organ - middle).norm());
    for (LandmarkPair& pair : pairs)
        pair.organ = (pair.organ - middle) / size;
}

} // namespace esm
