#include "core/texture/photo/photo_sampler.h"

#include "core/texture/photo/bilinear.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <smmintrin.h>
#include <tbb/parallel_for.h>

namespace esm {

namespace {

/// Red, green, blue and alpha, 0 to 255. The four bytes become floats in one register: one by one this took
/// most of a composition's time.
Eigen::Array4f valuesOf(const std::uint8_t* pixel) {
    std::int32_t bytes = 0;
    std::memcpy(&bytes, pixel, sizeof bytes);
    Eigen::Array4f values;
    _mm_store_ps(values.data(), _mm_cvtepi32_ps(_mm_cvtepu8_epi32(_mm_cvtsi32_si128(bytes))));
    return values;
}

/// Rounds values that are not below 0.
void store(const Eigen::Array4f& values, std::uint8_t* pixel) {
    const __m128i rounded = _mm_cvttps_epi32(_mm_add_ps(_mm_load_ps(values.data()), _mm_set1_ps(0.5F)));
    const __m128i words = _mm_packus_epi32(rounded, rounded);
    const std::int32_t bytes = _mm_cvtsi128_si32(_mm_packus_epi16(words, words));
    std::memcpy(pixel, &bytes, sizeof bytes);
}

/// Colours weighted by alpha, and the weighted alpha, 0 to 255. What is transparent has some colour in its
/// bytes, mostly black; averaged like any other it would darken the border of what shows.
struct WeightedColour {
    Eigen::Array4f sum = Eigen::Array4f::Zero();

    void add(const std::uint8_t* pixel, float weight) {
        Eigen::Array4f values = valuesOf(pixel);
        const float alpha = weight * values[3];
        values[3] = 1;
        sum += alpha * values;
    }
    Eigen::Array4f colour() const {
        if (sum[3] <= 0) return Eigen::Array4f::Zero();
        return {sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3], sum[3]};
    }
};

/// The pixels around a place, in which alpha weighs nothing.
inline Eigen::Array4f opaqueColourAt(const Image& image, double x, double y) {
    const BilinearPlace place = bilinearPlace(image, x, y);
    const auto u = static_cast<float>(place.u), v = static_cast<float>(place.v);
    const Eigen::Array4f left = valuesOf(image.at(place.left, place.top)),
                         lowerLeft = valuesOf(image.at(place.left, place.bottom));
    const Eigen::Array4f top = left + u * (valuesOf(image.at(place.right, place.top)) - left);
    const Eigen::Array4f bottom = lowerLeft + u * (valuesOf(image.at(place.right, place.bottom)) - lowerLeft);
    return top + v * (bottom - top);
}

bool allOpaque(const Image& image) {
    for (std::size_t i = 3; i < image.pixels.size(); i += 4)
        if (image.pixels[i] != 255) return false;
    return true;
}

/// The mean of four pixels.
template<bool isOpaque> Eigen::Array4f meanOf(const std::array<const std::uint8_t*, 4>& pixels) {
    if constexpr (isOpaque)
        return 0.25F *
               (valuesOf(pixels[0]) + valuesOf(pixels[1]) + valuesOf(pixels[2]) + valuesOf(pixels[3]));
    WeightedColour mean;
    for (const std::uint8_t* pixel : pixels)
        mean.add(pixel, 0.25F);
    return mean.colour();
}

template<bool isOpaque> void halveRow(const Image& image, int y, Image& half) {
    const int above = 2 * y, below = std::min(above + 1, image.height - 1);
    for (int x = 0; x < half.width; ++x) {
        const int left = 2 * x, right = std::min(left + 1, image.width - 1);
        const Eigen::Array4f colour = meanOf<isOpaque>(
            {image.at(left, above), image.at(right, above), image.at(left, below), image.at(right, below)});
        store(colour, half.at(x, y));
    }
}

Image halved(const Image& image, bool isOpaque) {
    Image half;
    half.width = (image.width + 1) / 2;
    half.height = (image.height + 1) / 2;
    half.pixels.resize(4 * static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    tbb::parallel_for(0, half.height, [&](int y) {
        isOpaque ? halveRow<true>(image, y, half) : halveRow<false>(image, y, half);
    });
    return half;
}

} // namespace

Eigen::Vector4f weightedColourAt(const Image& image, double x, double y) {
    const BilinearPlace place = bilinearPlace(image, x, y);
    const auto u = static_cast<float>(place.u), v = static_cast<float>(place.v);
    WeightedColour mean;
    mean.add(image.at(place.left, place.top), (1 - u) * (1 - v));
    mean.add(image.at(place.right, place.top), u * (1 - v));
    mean.add(image.at(place.left, place.bottom), (1 - u) * v);
    mean.add(image.at(place.right, place.bottom), u * v);
    return mean.colour();
}

Image halved(const Image& image) {
    return halved(image, allOpaque(image));
}

Image shrunk(const Image& image, int longestSide) {
    const auto isTooLarge = [&](const Image& picture) {
        return std::max(picture.width, picture.height) > longestSide;
    };
    if (!isTooLarge(image)) return image;
    Image smaller = halved(image);
    while (isTooLarge(smaller))
        smaller = halved(smaller);
    return smaller;
}

/// A pyramid of halved pictures (Williams 1983, Pyramidal parametrics): the levels after the first have ¼ +
/// 1/16 + … of its pixels, a third. The mean of any square is then eight readings, four pixels in each of two
/// levels, however large the square is; to add its pixels up would take longer the smaller the photo is seen.
PhotoSampler::PhotoSampler(const Image& photo) : m_photo(photo), m_isOpaque(allOpaque(photo)) {
    while (level(m_smaller.size()).width > 1 || level(m_smaller.size()).height > 1)
        m_smaller.push_back(halved(level(m_smaller.size()), m_isOpaque));
}

/// Two neighbouring levels are mixed by the fraction of the depth, else a seam would show where one changes
/// into the other. A level's pixels are twice as wide, so places are halved with each; centres at 0.5 make
/// that exact.
Eigen::Vector4f PhotoSampler::at(double x, double y, double depth) const {
    depth = std::clamp(depth, 0.0, static_cast<double>(m_smaller.size()));
    const auto fine = static_cast<std::size_t>(depth);
    const auto share = static_cast<float>(depth - static_cast<double>(fine));
    const double scale = 1.0 / static_cast<double>(std::uint64_t{1} << fine);
    x *= scale;
    y *= scale;
    if (!m_isOpaque) return colourByAlphaAt(x, y, fine, share);
    const Eigen::Array4f alphaAsShare(1, 1, 1, 1.0F / 255);
    const Eigen::Array4f colour = opaqueColourAt(level(fine), x, y);
    if (!(share > 0)) return colour * alphaAsShare;
    const Eigen::Array4f coarse = opaqueColourAt(level(fine + 1), x / 2, y / 2);
    return (colour + share * (coarse - colour)) * alphaAsShare;
}

Eigen::Vector4f PhotoSampler::colourByAlphaAt(double x, double y, std::size_t fine, float share) const {
    Eigen::Vector4f colour = weightedColourAt(level(fine), x, y);
    if (share > 0) {
        const Eigen::Vector4f coarse = weightedColourAt(level(fine + 1), x / 2, y / 2);
        const float alpha = (1 - share) * colour.w() + share * coarse.w();
        if (!(alpha > 0)) return Eigen::Vector4f::Zero();
        colour = ((1 - share) * colour.w() * colour + share * coarse.w() * coarse) / alpha;
        colour.w() = alpha;
    }
    colour.w() /= 255;
    return colour;
}

} // namespace esm
