#include "core/texture/photo/photo_sampler.h"

#include "core/texture/photo/bilinear.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <smmintrin.h>
#include <tbb/parallel_for.h>

namespace esm {

namespace {

/// Red, green, blue and alpha, 0 to 255.
Eigen::Array4f valuesOf(const std::uint8_t* pixel) {
    std::int32_t bytes = 0;
    std::memcpy(&bytes, pixel, sizeof bytes);
    Eigen::Array4f values;
    _mm_store_ps(values.data(), _mm_cvtepi32_ps(_mm_cvtepu8_epi32(_mm_cvtsi32_si128(bytes))));
    return values;
}

/// Colours weighted by alpha, and the weighted alpha, 0 to 255.
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
Eigen::Array4f opaqueColourAt(const Image& image, const BilinearPlace& place) {
    const auto u = static_cast<float>(place.u), v = static_cast<float>(place.v);
    const Eigen::Array4f left = valuesOf(image.at(place.left, place.top)),
                         lowerLeft = valuesOf(image.at(place.left, place.bottom));
    const Eigen::Array4f top = left + u * (valuesOf(image.at(place.right, place.top)) - left);
    const Eigen::Array4f bottom = lowerLeft + u * (valuesOf(image.at(place.right, place.bottom)) - lowerLeft);
    return top + v * (bottom - top);
}

Eigen::Array4f colourByAlphaAt(const Image& image, const BilinearPlace& place) {
    const auto u = static_cast<float>(place.u), v = static_cast<float>(place.v);
    WeightedColour mean;
    mean.add(image.at(place.left, place.top), (1 - u) * (1 - v));
    mean.add(image.at(place.right, place.top), u * (1 - v));
    mean.add(image.at(place.left, place.bottom), (1 - u) * v);
    mean.add(image.at(place.right, place.bottom), u * v);
    return mean.colour();
}

bool allOpaque(const Image& image) {
    for (std::size_t i = 3; i < image.pixels.size(); i += 4)
        if (image.pixels[i] != 255) return false;
    return true;
}

} // namespace

Eigen::Vector4f weightedColourAt(const Image& image, double x, double y) {
    return colourByAlphaAt(image, bilinearPlace(image, x, y));
}

Image halved(const Image& image) {
    Image half;
    half.width = (image.width + 1) / 2;
    half.height = (image.height + 1) / 2;
    half.pixels.resize(4 * static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    tbb::parallel_for(0, half.height, [&](int y) {
        const int below = std::min(2 * y + 1, image.height - 1);
        for (int x = 0; x < half.width; ++x) {
            const int right = std::min(2 * x + 1, image.width - 1);
            WeightedColour mean;
            mean.add(image.at(2 * x, 2 * y), 0.25F);
            mean.add(image.at(right, 2 * y), 0.25F);
            mean.add(image.at(2 * x, below), 0.25F);
            mean.add(image.at(right, below), 0.25F);
            const Eigen::Array4f colour = mean.colour() + 0.5F;
            for (int channel = 0; channel < 4; ++channel)
                half.at(x, y)[channel] = static_cast<std::uint8_t>(colour[channel]);
        }
    });
    return half;
}

PhotoSampler::PhotoSampler(const Image& photo) : m_photo(photo), m_isOpaque(allOpaque(photo)) {
    while (level(m_smaller.size()).width > 1 || level(m_smaller.size()).height > 1)
        m_smaller.push_back(halved(level(m_smaller.size())));
}

Eigen::Array4f PhotoSampler::read(std::size_t index, double x, double y) const {
    const Image& image = level(index);
    const BilinearPlace place = bilinearPlace(image, x, y);
    return m_isOpaque ? opaqueColourAt(image, place) : colourByAlphaAt(image, place);
}

Eigen::Vector4f PhotoSampler::at(double x, double y, double depth) const {
    depth = std::clamp(depth, 0.0, static_cast<double>(m_smaller.size()));
    const auto fine = static_cast<std::size_t>(depth);
    const auto share = static_cast<float>(depth - static_cast<double>(fine));
    const double scale = 1.0 / static_cast<double>(std::uint64_t{1} << fine);
    const Eigen::Array4f whole(1, 1, 1, 255); // alpha becomes a share
    const Eigen::Array4f colour = read(fine, x * scale, y * scale);
    if (!(share > 0)) return colour / whole;
    const Eigen::Array4f coarse = read(fine + 1, x * scale / 2, y * scale / 2);
    if (m_isOpaque) return (colour + share * (coarse - colour)) / whole;
    const float alpha = colour[3] + share * (coarse[3] - colour[3]);
    if (!(alpha > 0)) return Eigen::Vector4f::Zero();
    const Eigen::Array4f mixed = ((1 - share) * colour[3] * colour + share * coarse[3] * coarse) / alpha;
    return {mixed[0], mixed[1], mixed[2], alpha / 255};
}

} // namespace esm
