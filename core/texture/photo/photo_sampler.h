#pragma once

#include "core/texture/image.h"

#include <Eigen/Core>

#include <vector>

namespace esm {

/// The picture at half its width and height, rounded up. Colours count by their alpha.
Image halved(const Image& image);

/// The longer side of a photo, pixels, beyond which something is looked for in a smaller copy: what is found
/// is many pixels wide there, and the photo's own size would take ten times its memory.
constexpr int longestLookedAt = 4096;

/// The picture, halved until no side is longer.
Image shrunk(const Image& image, int longestSide);

/// Red, green, blue and alpha, 0 to 255, between the pixels around a place; colours count by their alpha. The
/// place is in pixels from the top left corner, a pixel's centre at 0.5. Precondition: it is finite.
Eigen::Vector4f weightedColourAt(const Image& image, double x, double y);

/// Reads a photo between its pixels and at any size: a pyramid of halved pictures, so that a photo seen
/// smaller than its pixels does not flicker [R 4.3.2.4]. Colours count by their alpha, so transparent pixels
/// do not bleed.
class PhotoSampler {
public:
    explicit PhotoSampler(const Image& photo); ///< which must outlive the sampler

    /// Red, green, blue 0 to 255 and alpha 0 to 1 at a place in photo pixels from the top left corner, a
    /// pixel's centre at 0.5. `depth` 0 reads the photo itself, each further one averages twice as wide.
    Eigen::Vector4f at(double x, double y, double depth) const;

    int width() const { return m_photo.width; }
    int height() const { return m_photo.height; }

private:
    const Image& level(std::size_t index) const { return index == 0 ? m_photo : m_smaller[index - 1]; }

    /// @param x, y pixels of the level `fine`, with which the next is mixed by `share`
    Eigen::Vector4f colourByAlphaAt(double x, double y, std::size_t fine, float share) const;

    const Image& m_photo;
    bool m_isOpaque;              ///< nowhere transparent, so that alpha need not be weighed
    std::vector<Image> m_smaller; ///< each half the size of the one before
};

} // namespace esm
