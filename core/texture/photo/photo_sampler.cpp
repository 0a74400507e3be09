#include "core/texture/photo/photo_sampler.h"

#include "core/texture/photo/bilinear.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Colours weighted by alpha, and the weighted alpha, 0 to 255.
struct WeightedColour {
    Eigen::Vector4f sum = Eigen::Vector4f::Zero();

    void add(const std::uint8_t* pixel, float weight) {
        const float alpha = weight * static_cast<float>(pixel[3]);
        sum += alpha * Eigen::Vector4f(pixel[0], pixel[1], pixel[2], 1);
    }
    Eigen::Vector4f colour() const {
        if (sum.w() <= 0) return Eigen::Vector4f::Zero();
        return {sum.x() / sum.w(), sum.y() / sum.w(), sum.z() / sum.w(), sum.w()};
    }
};

Eigen::Array4f valuesOf(const std::uint8_t* pixel) {
    return Eigen::Map<const Eigen::Array<std::uint8_t, 4, 1>>(pixel).cast<float>();
}

} // namespace

Eigen::Vector4f weightedColourAt(const Image& image, double x, double y) {
    const BilinearPlace place = bilinearPlace(image, x, y);
    const auto u = static_cast<float>(place.u), v = static_cast<float>(place.v);
    const std::uint8_t *topLeft = image.at(place.left, place.top),
                       *topRight = image.at(place.right, place.top),
                       *bottomLeft = image.at(place.left, place.bottom),
                       *bottomRight = image.at(place.right, place.bottom);
    if ((topLeft[3] & topRight[3] & bottomLeft[3] & bottomRight[3]) == 255) { // alpha weighs nothing
        const Eigen::Array4f left = valuesOf(topLeft), right = valuesOf(topRight),
                             lowerLeft = valuesOf(bottomLeft), lowerRight = valuesOf(bottomRight);
        const Eigen::Array4f top = left + u * (right - left);
        const Eigen::Array4f bottom = lowerLeft + u * (lowerRight - lowerLeft);
        return top + v * (bottom - top);
    }
    WeightedColour mean;
    mean.add(topLeft, (1 - u) * (1 - v));
    mean.add(topRight, u * (1 - v));
    mean.add(bottomLeft, (1 - u) * v);
    mean.add(bottomRight, u * v);
    return mean.colour();
}

Image halved(const Image& image) {
    Image half;
    half.width = (image.width + 1) / 2;
    half.height = (image.height + 1) / 2;
    half.pixels.resize(4 * static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    for (int y = 0; y < half.height; ++y) {
        const int below = std::min(2 * y + 1, image.height - 1);
        for (int x = 0; x < half.width; ++x) {
            const int right = std::min(2 * x + 1, image.width - 1);
            WeightedColour mean;
            mean.add(image.at(2 * x, 2 * y), 0.25F);
            mean.add(image.at(right, 2 * y), 0.25F);
            mean.add(image.at(2 * x, below), 0.25F);
            mean.add(image.at(right, below), 0.25F);
            const Eigen::Vector4f colour = mean.colour();
            for (int channel = 0; channel < 4; ++channel)
                half.at(x, y)[channel] = static_cast<std::uint8_t>(std::lround(colour[channel]));
        }
    }
    return half;
}

PhotoSampler::PhotoSampler(const Image& photo) : m_photo(photo) {
    while (level(m_smaller.size()).width > 1 || level(m_smaller.size()).height > 1)
        m_smaller.push_back(halved(level(m_smaller.size())));
}

Eigen::Vector4f PhotoSampler::at(double x, double y, double depth) const {
    const double coarsest = static_cast<double>(m_smaller.size());
    depth = std::clamp(depth, 0.0, coarsest);
    const auto fine = static_cast<std::size_t>(depth);
    const auto share = static_cast<float>(depth - static_cast<double>(fine));
    const double scale = 1.0 / static_cast<double>(std::uint64_t{1} << fine);
    Eigen::Vector4f colour = weightedColourAt(level(fine), x * scale, y * scale);
    if (share > 0) {
        const Eigen::Vector4f coarse = weightedColourAt(level(fine + 1), x * scale / 2, y * scale / 2);
        const float alpha = (1 - share) * colour.w() + share * coarse.w();
        if (alpha > 0)
            colour.head<3>() =
                ((1 - share) * colour.w() * colour.head<3>() + share * coarse.w() * coarse.head<3>()) / alpha;
        colour.w() = alpha;
    }
    colour.w() /= 255;
    return colour;
}

} // namespace esm
