#include "core/texture/photo/colour_match.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <tbb/parallel_for.h>
#include <vector>

namespace esm {

namespace {

using Lab = cv::Mat; ///< a row of CIE L*a*b*, three floats a pixel

Lab labRow(const Image& image, int y) {
    cv::Mat row(1, image.width, CV_32FC3);
    for (int x = 0; x < image.width; ++x)
        for (int channel = 0; channel < 3; ++channel)
            row.at<cv::Vec3f>(0, x)[channel] = static_cast<float>(image.at(x, y)[channel]) / 255;
    cv::cvtColor(row, row, cv::COLOR_RGB2Lab);
    return row;
}

/// Weighted sums from which means and spreads follow.
struct ColourSums {
    double weight = 0;
    std::array<double, 3> sum{}, squares{};

    void add(const cv::Vec3f& lab, double share) {
        weight += share;
        for (std::size_t i = 0; i < 3; ++i) {
            const double value = lab[static_cast<int>(i)];
            sum[i] += share * value;
            squares[i] += share * value * value;
        }
    }
    void add(const ColourSums& other) {
        weight += other.weight;
        for (std::size_t i = 0; i < 3; ++i) {
            sum[i] += other.sum[i];
            squares[i] += other.squares[i];
        }
    }
    double mean(std::size_t i) const { return sum[i] / weight; }
    double spread(std::size_t i) const {
        return std::sqrt(std::max(0.0, squares[i] / weight - mean(i) * mean(i)));
    }
};

/// Both, over what is seen of both in one row.
std::array<ColourSums, 2> sumsOfRow(const Image& photo, const Image& beneath, int y) {
    const Lab above = labRow(photo, y), below = labRow(beneath, y);
    std::array<ColourSums, 2> sums;
    for (int x = 0; x < photo.width; ++x) {
        const double share = photo.at(x, y)[3] * beneath.at(x, y)[3] / (255.0 * 255.0);
        if (!(share > 0)) continue;
        sums[0].add(above.at<cv::Vec3f>(0, x), share);
        sums[1].add(below.at<cv::Vec3f>(0, x), share);
    }
    return sums;
}

} // namespace

std::optional<ColourMatch> matchColours(const Image& photo, const Image& beneath) {
    constexpr double fewestPixels = 100, flat = 0.5; // a spread below which there is nothing to scale
    if (photo.empty() || photo.width != beneath.width || photo.height != beneath.height) return std::nullopt;
    std::vector<std::array<ColourSums, 2>> rows(static_cast<std::size_t>(photo.height));
    tbb::parallel_for(0, photo.height,
                      [&](int y) { rows[static_cast<std::size_t>(y)] = sumsOfRow(photo, beneath, y); });
    std::array<ColourSums, 2> sums;
    for (const auto& row : rows)
        for (std::size_t picture = 0; picture < 2; ++picture)
            sums[picture].add(row[picture]);
    const auto& [from, to] = sums;
    if (from.weight < fewestPixels) return std::nullopt;
    ColourMatch match;
    for (std::size_t i = 0; i < 3; ++i) {
        if (from.spread(i) > flat && to.spread(i) > flat)
            match.scale[i] = std::clamp(to.spread(i) / from.spread(i), smallestSpread, largestSpread);
        match.offset[i] = to.mean(i) - match.scale[i] * from.mean(i);
    }
    return match;
}

void applyMatch(Image& photo, const ColourMatch& match) {
    const cv::Scalar scale(match.scale[0], match.scale[1], match.scale[2]);
    const cv::Scalar offset(match.offset[0], match.offset[1], match.offset[2]);
    tbb::parallel_for(0, photo.height, [&](int y) {
        Lab row = labRow(photo, y);
        cv::multiply(row, scale, row);
        cv::add(row, offset, row);
        cv::cvtColor(row, row, cv::COLOR_Lab2RGB);
        for (int x = 0; x < photo.width; ++x)
            for (int channel = 0; channel < 3; ++channel)
                photo.at(x, y)[channel] = static_cast<std::uint8_t>(
                    std::lround(255 * std::clamp(row.at<cv::Vec3f>(0, x)[channel], 0.0F, 1.0F)));
    });
}

} // namespace esm
